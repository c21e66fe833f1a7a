#pragma once

/// A function compiled for several widths of vector register, the widest that the machine has chosen when the program
/// starts. Everything it calls is inlined into it, or it would pass vectors between differently compiled functions.
/// Elsewhere (other machines, sanitizers, unoptimised) it is compiled once; the results are the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) &&                        \
    !defined(__SANITIZE_ADDRESS__)
#define RAPIDITY_FOR_EACH_REGISTER_WIDTH [[gnu::flatten, gnu::target_clones("default", "avx2", "arch=x86-64-v4")]]
#else
#define RAPIDITY_FOR_EACH_REGISTER_WIDTH
#endif

namespace sim {

/// Bits in the vector registers that the functions marked above use on this machine.
inline int register_width() {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__) &&                        \
    !defined(__SANITIZE_ADDRESS__)
    return __builtin_cpu_supports("x86-64-v4") ? 512 : __builtin_cpu_supports("avx2") ? 256 : 128;
#else
    return 128;
#endif
}

} // namespace sim
