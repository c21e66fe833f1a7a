#pragma once

#include "tests/program.h"

#include <map>
#include <string>
#include <vector>

/// The program itself, run with an environment of its own.
namespace xr_kit {

using tests::Run;
using tests::run_program;

/// The same on a display of its own, as large as any headset's window.
Run run_program_in_window(const std::vector<std::string>& words,
                          const std::map<std::string, std::string>& environment = {});

/// How often a text holds another.
int count(const std::string& text, const std::string& part);

} // namespace xr_kit
