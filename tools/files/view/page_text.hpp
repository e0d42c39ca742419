// The built page of the viewer, around the mark where the scene goes. cmake/embed.cmake writes the source.
#pragma once

namespace tamis::io {

/// Texts that follow each other; a null ends them.
extern const char* const kPageBeforeScene[];
extern const char* const kPageAfterScene[];

}  // namespace tamis::io
