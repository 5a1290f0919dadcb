# FFmpeg's libraries decode the smoke clips. They give the planes of a clip, alpha and timestamps, and can be limited
# to a list of formats; OpenCV's reader has none of that.
pkg_check_modules(ffmpeg REQUIRED IMPORTED_TARGET GLOBAL libavformat libavcodec libavutil libswscale)
