// When the scene is drawn, and how finely, while a person works: panels never wait for it. Without a GPU one picture of
// the scene takes up to half a second, and nothing else is shown meanwhile. So from an input until a moment after the
// last one the scene gets at most half of the time, in pieces too short to notice: it is drawn with as many pixels as
// fit into `budget`. At rest it is drawn whole again. Time is an argument; no OpenGL.
//
//     pace.touch(now);                                   // an input
//     if (pace.due(now)) { draw(pace.scale(now)); pace.drawn(now, after); }
#pragma once

#include <array>
#include <cstddef>
#include <limits>

namespace lapfx::app {

class ScenePace {
  public:
    static constexpr double budget = 0.04;  ///< s, of one picture while a person works
    static constexpr double rest = 0.3;     ///< s without input until it is drawn whole again

    /// A person does something: moves or presses what is seen.
    void touch(double now) { touched_ = now; }
    bool touched(double now) const { return now - touched_ < rest; }
    /// What one whole picture costs, s, as far as that is known, before drawn() tells better.
    void expect(double seconds);

    /// Whether it is the scene's turn. Right after an input the panels go first, once.
    bool due(double now) const;
    /// s: when it will be, where it is not yet at `now`. Until then frames are wanted for what happens only.
    double due_at(double now) const;
    /// Factor on width and height of the picture, as it is to be drawn now.
    double scale(double now) const { return touched(now) ? steps[step_] : 1; }
    /// A picture has been drawn, with scale(begin).
    void drawn(double begin, double end);
    /// It was the scene's turn at `now`, and nothing had to be drawn. At rest this means that no picture with fewer
    /// pixels is shown any more.
    void left_out(double now) { coarse_ = coarse_ && touched(now); }
    /// s: when a picture that was drawn with fewer pixels will be drawn whole; infinite where it is whole.
    double whole_at() const { return coarse_ ? touched_ + rest : std::numeric_limits<double>::infinity(); }

  private:
    static constexpr std::array<double, 5> steps{1, 0.7, 0.5, 0.35, 0.25};
    std::size_t step_ = 0;
    bool known_ = false;   ///< step_ comes from what was measured
    bool coarse_ = false;  ///< what is shown has fewer pixels
    double touched_ = -std::numeric_limits<double>::infinity();
    double ended_ = -std::numeric_limits<double>::infinity(), cost_ = 0;
};

}  // namespace lapfx::app
