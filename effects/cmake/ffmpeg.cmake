# FFmpeg's libraries decode the smoke clips: into the clip's own planes, with alpha, timestamps and a list of the
# formats that may be read, none of which OpenCV's reader gives.
pkg_check_modules(ffmpeg REQUIRED IMPORTED_TARGET GLOBAL libavformat libavcodec libavutil libswscale)
