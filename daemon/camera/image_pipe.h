#pragma once
// A pipe as a source of images: another program renders or receives them and writes one after the
// other, in netpbm's binary formats with a time stamp as a comment of the header:
//
//   P5                   grey, a byte a pixel; P6: red, green and blue
//   # taken_s 8123.4567  optional: the middle of the exposure, in seconds below 1e9, of the
//                        monotonic clock; of any if poses are only written to a file
//   1024 640             width and height
//   255                  and after one white space the pixels, rows from the top
//
// Programs that know no such comment (ffmpeg -f image2pipe -c:v pgm -) are read as well: an image
// without a stamp was taken when it arrived, less the delay.

#include <memory>
#include <string>

#include "camera/source.h"

namespace tp100::camera {

/// Reads from `descriptor`, which it closes unless it is standard input; `name` is for messages.
/// next() blocks, and returns false at the end, or within an image once `options.stop_fd` can be
/// read; it throws UserError for anything but such images.
std::unique_ptr<Source> open_image_pipe(int descriptor, const std::string& name,
                                        const SourceOptions& options);

}  // namespace tp100::camera
