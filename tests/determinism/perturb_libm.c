/* Preloaded: every function of the C library's mathematics gives a result one unit in the last place
   higher than it should, but for exact ones (0, 1, -1). What is promised to have the same bits
   everywhere must not notice. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <math.h>

static double off(double x) {
    return isfinite(x) && x != 0 && x != 1 && x != -1 ? nextafter(x, INFINITY) : x;
}
#define ONE(name)                                             \
    double name(double x) {                                   \
        static double (*real)(double);                        \
        if (!real) real = dlsym(RTLD_NEXT, #name);            \
        return off(real(x));                                  \
    }
#define TWO(name)                                             \
    double name(double x, double y) {                         \
        static double (*real)(double, double);                \
        if (!real) real = dlsym(RTLD_NEXT, #name);            \
        return off(real(x, y));                               \
    }
ONE(acos) ONE(asin) ONE(atan) ONE(cos) ONE(sin) ONE(tan) ONE(cosh) ONE(sinh) ONE(tanh)
ONE(log) ONE(log2) ONE(log10) ONE(log1p) ONE(exp) ONE(exp2) ONE(expm1) ONE(cbrt)
TWO(atan2) TWO(hypot) TWO(pow)

void sincos(double x, double* s, double* c) {
    static void (*real)(double, double*, double*);
    if (!real) real = dlsym(RTLD_NEXT, "sincos");
    real(x, s, c);
    *s = off(*s);
    *c = off(*c);
}
