#pragma once

#include <filesystem>
#include <string>

namespace engine {

/// A new folder under the system's temporary one, removed with everything in it.
class TemporaryFolder {
  public:
    /// Throws Failure when it cannot be made.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

} // namespace engine
