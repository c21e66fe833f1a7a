#pragma once

#include "content/scene_desc.h"

#include <filesystem>
#include <string>

namespace engine {

/// The folder-less name found along $PATH; "" when there is none.
std::filesystem::path program_on_path(const std::string& name);

/// Makes a film of numbered pictures ("frame-%06d.png", from 1) with ffmpeg, by the extension of `film`: .mp4 and .mov
/// H.264, .webm VP9. One thread and no times in it: the same pictures give the same bytes. `description` becomes its
/// comment. All or nothing: a file of that name stays until the new one is complete. One line on what went wrong, or
/// "".
std::string encode_frames(const std::filesystem::path& pattern, double frames_per_second,
                          const std::string& description, const std::filesystem::path& film);

/// Makes a film (mp4, H.264) by piping raw pictures to ffmpeg. Troubles do not throw: the flight goes on without the
/// film and `trouble` says why.
class Film {
  public:
    /// `width`, `height`: pixels of every picture; `frames_per_second` > 0. An existing file is replaced.
    Film(std::filesystem::path file, int width, int height, double frames_per_second);
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    /// Appends a picture of the size given at the start.
    void add(const content::Image& picture);
    /// Completes the file; nothing can be added afterwards. False when there is no film, see `trouble`.
    bool finish();

    const std::filesystem::path& file() const { return file_; }
    /// One line; "" while all is well.
    const std::string& trouble() const { return trouble_; }

  private:
    void start(int width, int height, double frames_per_second);

    std::filesystem::path file_;
    std::string trouble_;
    int process_ = -1; ///< of ffmpeg; -1: none
    int pipe_ = -1;    ///< to its standard input; -1: closed
};

} // namespace engine
