// The sample's reference with one frame of four: to measure the whole one takes fifteen seconds.
#pragma once

#include "app/editor.h"
#include "lapfx/authoring/video.h"
#include "output/files.h"
#include "support/folders.h"
#include "unit/preset/support.h"

namespace lapfx::test {

/// Its file, the same for all tests of a process.
inline const std::filesystem::path& few_frames() {
    struct Video {
        Video() {
            VideoReader whole(light_folder() / "samples/reference/operation.mp4");
            const VideoInfo& info = whole.info();
            output::VideoFile few(file, info.frames_per_second / 4, {info.size.x, info.size.y});
            Image frame;
            for (int i = 0; i < info.frames; i += 4) {
                EXPECT_TRUE(whole.read(i, frame));
                few.add(frame);
            }
            few.finish();
        }
        Folder folder;
        std::filesystem::path file = folder / "operation.mp4";
    };
    static const Video video;
    return video.file;
}

/// What is open is opened again, with that as its reference.
inline void take_few_frames(app::Editor& editor) {
    document::Content content = editor.document.content();
    content.scene.reference.file = few_frames().string();
    editor.document.open(std::move(content), editor.document.scene_file(), editor.document.preset_file());
}

}  // namespace lapfx::test
