#pragma once

#include "engine/database.h"
#include "sim/quantities.h"

#include <filesystem>
#include <string>
#include <vector>

namespace engine {

/// A moment of a recorded flight that somebody who watched it has marked. No part of the flight: no checksum covers it.
struct Bookmark {
    sim::Tick tick = 0;
    std::string what; ///< one line
};

/// Of an open recording's table; none where it has no such table.
std::vector<Bookmark> read_bookmarks(Database& recording);
/// Of the file beside a recording; none where there is no such file. Throws sim::BadInput for what is no bookmark.
std::vector<Bookmark> read_bookmarks_beside(const std::filesystem::path& recording);

/// Keeps a bookmark in the recording, or, where that cannot be written, in FILE.bookmarks.csv beside it (tick,what).
/// Returns the file that it is in. Throws sim::BadInput where neither can be written.
std::filesystem::path keep_bookmark(const std::filesystem::path& recording, const Bookmark& bookmark);

} // namespace engine
