#pragma once

#include <string>

/// Where the tests find what they test. Functions, so that only one file is compiled with the folders' names.
namespace tests {

/// The project's root folder, absolute, without a closing slash.
std::string source_folder();
/// The program `rapidity` of this build, absolute.
std::string program();

} // namespace tests
