// Travel distance of blood: accuracy and time of our fronts compared with other methods, on surfaces with known
// distances.
//
//     lapfx_bench_distances [--short] [--json FILE]
//
// On a plane and a sphere the truth is a closed form; on the sample stomach it is CGAL's exact geodesics (Xin and Wang
// 2009). The methods: our front; counting edges (Dijkstra, which is the paper's "mesh connectivity and vertex
// neighbours" with lengths); CGAL's heat method (Crane, Weischedel, Wardetzky 2013), built without assertions.
// Preparation that is done once for a surface counts separately: CGAL's factorisation, our memory. The heat method
// gives all vertices at once, the front and Dijkstra those within reach of the blood, so times are also per vertex
// reached, and one front covers the whole surface. The best of three runs of each, in turns, CPU time of the thread.
// --short: small surfaces, once. Finally a frame of growing blood is compared with a sweep over all vertices.
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <queue>

#include "bleeding/bleed_cpu.h"
#include "support/folders.h"
#include "support/meshes.h"

namespace lapfx::bleeding {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr double reach = 20.0;      // mm
constexpr double everywhere = 1e6;  // mm
constexpr double unknown = -1.0;

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool short_form = false;

/// Seconds of the fastest of three runs.
double fastest(const std::function<void()>& work) {
    double best = 1e9;
    for (int i = 0; i < (short_form ? 1 : 3); ++i) {
        const double start = cpu_seconds();
        work();
        best = std::min(best, cpu_seconds() - start);
    }
    return best;
}

using Distances = std::vector<double>;  // per surface vertex, mm; unknown where none was found

Mesh cgal_mesh(const Surface& surface) {
    Mesh mesh;
    for (const glm::dvec3& p : surface.positions) mesh.add_vertex({p.x, p.y, p.z});
    for (const auto& c : surface.triangles)
        mesh.add_face(Mesh::Vertex_index(c[0]), Mesh::Vertex_index(c[1]), Mesh::Vertex_index(c[2]));
    return mesh;
}

Distances by_front(const Surface& surface, std::uint32_t from) {
    FrontRoom room(surface, {0.0, -1.0, 0.0});
    Distances found(surface.positions.size(), unknown);
    for (const Reached& r : march(room, {}, surface.positions[from], reach)) found[r.vertex] = r.distance;
    return found;
}

std::size_t count_reached(const Distances& found) {
    return static_cast<std::size_t>(std::count_if(found.begin(), found.end(), [](double d) { return d != unknown; }));
}

Distances by_edges(const Surface& surface, std::uint32_t from) {
    Distances found(surface.positions.size(), unknown), best(surface.positions.size(), 1e30);
    using Candidate = std::pair<double, std::uint32_t>;
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> front;
    front.push({best[from] = 0.0, from});
    while (!front.empty()) {
        const auto [distance, v] = front.top();
        front.pop();
        if (distance > reach) break;
        if (distance > best[v]) continue;
        found[v] = distance;
        for (const std::uint32_t n : surface.neighbours_of(v)) {
            const double there = distance + glm::distance(surface.positions[v], surface.positions[n]);
            if (there < best[n]) front.push({best[n] = there, n});
        }
    }
    return found;
}

struct Row {
    std::string surface, way;
    std::size_t triangles;
    double mean_error, worst_error, seconds;  // relative to the distance, from 2 mm on
};

class Bench {
  public:
    void run(const std::string& name, const Surface& surface, std::uint32_t from,
             const std::function<double(std::uint32_t)>& closed_form) {
        Mesh mesh = cgal_mesh(surface);
        Distances truth(surface.positions.size()), heat(truth.size()), exact(truth.size());
        const double heat_set_up = fastest([&] { Heat set_up(mesh); });
        Heat method(mesh);
        const double heat_seconds = fastest([&] {
            method.clear_sources();
            method.add_source(Mesh::Vertex_index(from));
            const auto map = mesh.add_property_map<Mesh::Vertex_index, double>("v:heat", 0.0).first;
            method.estimate_geodesic_distances(map);
            for (std::uint32_t v = 0; v < heat.size(); ++v) heat[v] = map[Mesh::Vertex_index(v)];
        });
        double exact_seconds = 0.0;
        if (surface.triangles.size() <= 30'000) exact_seconds = exact_distances(mesh, from, exact);
        for (std::uint32_t v = 0; v < truth.size(); ++v) truth[v] = closed_form ? closed_form(v) : exact[v];
        FrontRoom room(surface, {0.0, -1.0, 0.0});  // Effects also makes it once
        const double room_set_up = fastest([&] { FrontRoom again(surface, {0.0, -1.0, 0.0}); });
        const double front_seconds = fastest([&] { march(room, {}, surface.positions[from], reach); });
        std::size_t all = 0;
        const double whole_seconds =
            fastest([&] { all = march(room, {}, surface.positions[from], everywhere).size(); });
        const double edge_seconds = fastest([&] { by_edges(surface, from); });
        compare(name, "front", surface, by_front(surface, from), truth, front_seconds);
        compare(name, "edges", surface, by_edges(surface, from), truth, edge_seconds);
        compare(name, "heat method", surface, heat, truth, heat_seconds);
        rows_.push_back({name, "heat method, set-up", surface.triangles.size(), 0.0, 0.0, heat_set_up});
        if (exact_seconds > 0.0) compare(name, "exact", surface, exact, truth, exact_seconds);
        rows_.push_back({name, "front, set-up", surface.triangles.size(), 0.0, 0.0, room_set_up});
        rows_.push_back({name, "front, whole surface", surface.triangles.size(), 0.0, 0.0, whole_seconds});
        const auto vertices = static_cast<double>(truth.size());
        const double front_each = front_seconds / static_cast<double>(count_reached(by_front(surface, from))),
                     heat_each = heat_seconds / vertices;
        ratios_[name + "_front_over_heat_time_per_vertex_reached"] = front_each / heat_each;
        ratios_[name + "_front_over_heat_time_whole_surface"] =
            whole_seconds / heat_seconds * vertices / static_cast<double>(all);
        ratios_[name + "_front_over_heat_time_of_one_wound"] = front_seconds / heat_seconds;
        ratios_[name + "_front_over_heat_set_up"] = room_set_up / heat_set_up;
        ratios_[name + "_front_over_heat_error"] = mean_of(name, "front") / mean_of(name, "heat method");
        ratios_[name + "_front_over_edges_error"] = mean_of(name, "front") / mean_of(name, "edges");
    }

    /// A frame of growing blood on a million vertices.
    void sweep() {
        const Organ organ = test::plane(500.0, short_form ? 50 : 1000);
        const Surface surface(organ);
        BleedField field(surface, {0.0, -1.0, 0.0});
        field.set(std::vector<Wound>{{.position = {0.13, 0.0, 0.21}}}, BleedingParameters{});
        field.update(0.0);
        double ours = 0.0;
        int frames = 0;
        for (double time = 1.0 / 60.0; time < 3.5; time += 1.0 / 60.0, ++frames) {
            const double start = cpu_seconds();
            field.update(time);
            ours += cpu_seconds() - start;
        }
        ours /= frames;
        // A sweep: the value of every vertex from a known distance.
        std::vector<float> distance(organ.positions.size(), 3.0f), value(organ.positions.size());
        volatile float source = 5.0f;
        const double all = fastest([&] {
            for (std::size_t v = 0; v < value.size(); ++v) value[v] = std::max(-1000.0f, source - distance[v]);
        });
        rows_.push_back({"a million vertices", "growing frame", surface.triangles.size(), 0.0, 0.0, ours});
        rows_.push_back({"a million vertices", "sweep over all", surface.triangles.size(), 0.0, 0.0, all});
        ratios_["frame_over_sweep_1m"] = ours / all;
    }

    void print() const {
        for (const Row& r : rows_)
            std::printf("%-20s %9zu triangles  %-20s  mean error %7.3f %%  worst %7.3f %%  %9.3f ms\n",
                        r.surface.c_str(), r.triangles, r.way.c_str(), 100.0 * r.mean_error, 100.0 * r.worst_error,
                        1e3 * r.seconds);
        for (const auto& [name, value] : ratios_) std::printf("%s %.3g\n", name.c_str(), value);
    }

    void write(const char* path) const {
        nlohmann::json results = nlohmann::json::array();
        for (const Row& r : rows_)
            results.push_back({{"surface", r.surface},
                               {"way", r.way},
                               {"triangles", r.triangles},
                               {"mean_error", r.mean_error},
                               {"worst_error", r.worst_error},
                               {"cpu_ms", 1e3 * r.seconds}});
        std::ofstream(path) << nlohmann::json{{"bench", "distances"}, {"results", results}, {"ratios", ratios_}}.dump(2)
                            << '\n';
    }

  private:
    using Heat = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh>;

    static double exact_distances(Mesh& mesh, std::uint32_t from, Distances& exact) {
        using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
        const double start = cpu_seconds();
        CGAL::Surface_mesh_shortest_path<Traits> paths(mesh);
        paths.add_source_point(Mesh::Vertex_index(from));
        for (std::uint32_t v = 0; v < exact.size(); ++v)
            exact[v] = paths.shortest_distance_to_source_points(Mesh::Vertex_index(v)).first;
        return cpu_seconds() - start;
    }

    void compare(const std::string& name, const std::string& way, const Surface& surface, const Distances& found,
                 const Distances& truth, double seconds) {
        double sum = 0.0, worst = 0.0;
        int count = 0;
        for (std::size_t v = 0; v < truth.size(); ++v) {
            if (truth[v] < 2.0 || truth[v] > reach - 1.0 || found[v] == unknown) continue;
            const double error = std::abs(found[v] - truth[v]) / truth[v];
            sum += error;
            worst = std::max(worst, error);
            ++count;
        }
        rows_.push_back({name, way, surface.triangles.size(), sum / count, worst, seconds});
    }

    double mean_of(const std::string& name, const std::string& way) const {
        for (const Row& r : rows_)
            if (r.surface == name && r.way == way) return r.mean_error;
        return 0.0;
    }

    std::vector<Row> rows_;
    std::map<std::string, double> ratios_;
};

std::uint32_t nearest(const Surface& surface, glm::dvec3 place) {
    std::uint32_t best = 0;
    for (std::uint32_t v = 0; v < surface.positions.size(); ++v)
        if (glm::distance(surface.positions[v], place) < glm::distance(surface.positions[best], place)) best = v;
    return best;
}

/// The largest component of an organ, which CGAL can take.
Surface largest_part(const Organ& organ) {
    const Surface all(organ);
    std::map<std::uint32_t, std::size_t> sizes;
    for (const auto& c : all.triangles) ++sizes[all.component[c[0]]];
    const auto largest =
        std::max_element(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    Organ part = organ;
    part.indices.clear();
    for (std::size_t t = 0; t < all.triangles.size(); ++t)
        if (all.component[all.triangles[t][0]] == largest->first)
            part.indices.insert(part.indices.end(), organ.indices.begin() + static_cast<std::ptrdiff_t>(3 * t),
                                organ.indices.begin() + static_cast<std::ptrdiff_t>(3 * t + 3));
    // The vertices of other parts are left out.
    std::map<std::uint32_t, std::uint32_t> kept;
    Organ compact;
    for (const std::uint32_t i : part.indices) {
        const auto [at, fresh] = kept.try_emplace(i, static_cast<std::uint32_t>(compact.positions.size()));
        if (fresh) compact.positions.push_back(organ.positions[i]);
        compact.indices.push_back(at->second);
    }
    return Surface(compact);
}

void run(const char* json) {
    Bench bench;
    const Surface plane(test::plane(60.0, short_form ? 40 : 120, test::Cut::irregular));
    const std::uint32_t middle = nearest(plane, {0, 0, 0});
    bench.run("plane", plane, middle,
              [&](std::uint32_t v) { return glm::distance(plane.positions[v], plane.positions[middle]); });
    const Surface sphere(test::sphere(30.0, short_form ? 3 : 5));
    const std::uint32_t pole = nearest(sphere, {0, 30, 0});
    bench.run("sphere", sphere, pole, [&](std::uint32_t v) {
        const double cosine = glm::dot(sphere.positions[v], sphere.positions[pole]) / 900.0;
        return 30.0 * std::acos(std::clamp(cosine, -1.0, 1.0));
    });
    if (!short_form) {  // the exact distances alone take many seconds
        const Surface stomach = largest_part(load_organ(test::source_folder() / "samples/lagb.glb"));
        bench.run("sample_organ", stomach, nearest(stomach, {20, 0, 10}), nullptr);
    }
    bench.sweep();
    bench.print();
    if (json != nullptr) bench.write(json);
}

}  // namespace
}  // namespace lapfx::bleeding

int main(int argc, char** argv) {
    const char* json = nullptr;
    for (int i = 1; i < argc; ++i) {
        const std::string option = argv[i];
        if (option == "--short") {
            lapfx::bleeding::short_form = true;
        } else if (option == "--json" && i + 1 < argc) {
            json = argv[++i];
        } else {
            std::fprintf(stderr, "usage: lapfx_bench_distances [--short] [--json FILE]\n");
            return 2;
        }
    }
    lapfx::bleeding::run(json);
    return 0;
}
