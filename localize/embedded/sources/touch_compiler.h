/* What the code asks of a compiler: all files include this one first. */
#ifndef TOUCH_COMPILER_H
#define TOUCH_COMPILER_H

/* Lost samples are NaN and absent limits are infinite, which these options of compilers assume away: every decision
 * after them would be wrong. */
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || defined(_M_FP_FAST)
#error "compile without -ffast-math, -Ofast, -ffinite-math-only and /fp:fast: lost samples are NaN"
#endif

#endif
