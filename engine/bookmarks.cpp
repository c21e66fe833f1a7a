#include "engine/bookmarks.h"

#include "engine/recording_format.h"
#include "sim/bad_input.h"

#include <charconv>
#include <fmt/format.h>
#include <fstream>

namespace engine {
namespace {

std::filesystem::path file_beside(const std::filesystem::path& recording) {
    return recording.string() + ".bookmarks.csv";
}

/// False where the recording cannot be written.
bool keep_inside(const std::filesystem::path& recording, const Bookmark& bookmark) {
    try {
        Database database = Database::create(recording);
        database.execute(bookmarks_table); // older recordings have none
        database.prepare("INSERT INTO bookmarks (tick, what) VALUES (?, ?)")
            .bind(0, static_cast<std::int64_t>(bookmark.tick))
            .bind(1, std::string_view(bookmark.what))
            .run();
        return true;
    } catch (const DatabaseError&) {
        return false;
    }
}

} // namespace

std::vector<Bookmark> read_bookmarks(Database& recording) {
    std::vector<Bookmark> bookmarks;
    if (recording.integer("SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = 'bookmarks'") == 0) {
        return bookmarks;
    }
    Statement select = recording.prepare("SELECT tick, what FROM bookmarks ORDER BY tick, id");
    while (select.step()) {
        bookmarks.push_back({read_tick(select, 0), select.text(1)});
    }
    return bookmarks;
}

std::vector<Bookmark> read_bookmarks_beside(const std::filesystem::path& recording) {
    const std::filesystem::path file = file_beside(recording);
    std::vector<Bookmark> bookmarks;
    std::ifstream stream(file);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        Bookmark bookmark;
        const char* const end = line.data() + line.size();
        const auto [rest, error] = std::from_chars(line.data(), end, bookmark.tick);
        if (error != std::errc() || rest == end || *rest != ',' || bookmark.tick > largest_tick) {
            throw sim::BadInput(file.string(), fmt::format("line {}", number), line, "must be a tick, a comma, a name");
        }
        bookmark.what.assign(rest + 1, end);
        bookmarks.push_back(std::move(bookmark));
    }
    return bookmarks;
}

std::filesystem::path keep_bookmark(const std::filesystem::path& recording, const Bookmark& bookmark) {
    if (keep_inside(recording, bookmark)) {
        return recording;
    }
    std::filesystem::path beside = file_beside(recording);
    std::ofstream stream(beside, std::ios::app);
    stream << fmt::format("{},{}\n", bookmark.tick, bookmark.what);
    stream.close();
    if (!stream) {
        throw sim::BadInput(recording.string(), "", "", "neither it nor a file beside it can be written");
    }
    return beside;
}

} // namespace engine
