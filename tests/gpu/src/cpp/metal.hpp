// Stands in for <metal_stdlib>: what naga writes for the mirror, as C++17 of GCC or Clang.

#include <cmath>
#include <cstdint>
#include <cstring>

#define kernel static
#define device
#define constant static const

namespace metal {

using uint = std::uint32_t;

// Components of a vector by their places, in the storage of the vector: both compilers read any
// member of a union.
template <class Of, class To, int... PLACES>
struct Swizzle {
    typename Of::Scalar data[Of::SIZE];
    operator To() const { return To(data[PLACES]...); }
};

// Arithmetic by components: of two vectors, and of a vector and a scalar.
#define OPERATOR(V, op)                                                      \
    friend V operator op(V a, V b) {                                         \
        for (int k = 0; k < SIZE; k++) a.data[k] = a.data[k] op b.data[k];   \
        return a;                                                            \
    }                                                                        \
    friend V operator op(V a, Scalar b) { return a op V(b); }                \
    friend V operator op(Scalar a, V b) { return V(a) op b; }
#define VECTOR(V, T, N)                                                      \
    using Scalar = T;                                                        \
    static constexpr int SIZE = N;                                           \
    V() : data{} {}                                                          \
    explicit V(T s) { for (int k = 0; k < N; k++) data[k] = s; }             \
    T& operator[](int k) { return data[k]; }                                 \
    T operator[](int k) const { return data[k]; }                            \
    OPERATOR(V, +)                                                           \
    OPERATOR(V, -)                                                           \
    OPERATOR(V, *)

// Booleans of a comparison by components.
template <int N>
struct Bools {
    bool data[N];
    bool operator[](int k) const { return data[k]; }
};
using bool2 = Bools<2>;
using bool3 = Bools<3>;
using bool4 = Bools<4>;
#define COMPARED(V, N)                                                       \
    friend Bools<N> operator<(V a, V b) {                                    \
        Bools<N> less;                                                       \
        for (int k = 0; k < N; k++) less.data[k] = a.data[k] < b.data[k];    \
        return less;                                                         \
    }                                                                        \
    friend Bools<N> operator>(V a, V b) { return b < a; }

struct float2 {
    struct XY { using Scalar = float; static constexpr int SIZE = 2; };
    union { struct { float x, y; }; float data[2]; Swizzle<XY, float2, 1, 0> yx; };
    VECTOR(float2, float, 2)
    OPERATOR(float2, /)
    COMPARED(float2, 2)
    float2(float a, float b) : x(a), y(b) {}
    friend float2 operator-(float2 a) { return float2(-a.x, -a.y); }
};

struct float3 {
    struct XYZ { using Scalar = float; static constexpr int SIZE = 3; };
    union {
        struct { float x, y, z; };
        float data[3];
        Swizzle<XYZ, float2, 0, 1> xy;
        Swizzle<XYZ, float2, 1, 2> yz;
    };
    VECTOR(float3, float, 3)
    float3(float a, float b, float c) : x(a), y(b), z(c) {}
    float3(float2 a, float b) : x(a.x), y(a.y), z(b) {}
    friend float3 operator-(float3 a) { return float3(-a.x, -a.y, -a.z); }
};
using packed_float3 = float3;

struct float4 {
    struct XYZW { using Scalar = float; static constexpr int SIZE = 4; };
    union {
        struct { float x, y, z, w; };
        float data[4];
        Swizzle<XYZW, float2, 0, 1> xy;
        Swizzle<XYZW, float2, 0, 2> xz;
        Swizzle<XYZW, float2, 2, 3> zw;
        Swizzle<XYZW, float2, 3, 2> wz;
        Swizzle<XYZW, float4, 1, 2, 3, 0> yzwx;
    };
    VECTOR(float4, float, 4)
    OPERATOR(float4, /)
    COMPARED(float4, 4)
    float4(float a, float b, float c, float d) : x(a), y(b), z(c), w(d) {}
    friend float4 operator-(float4 a) { return float4(-a.x, -a.y, -a.z, -a.w); }
};

struct int2 {
    union { struct { int x, y; }; int data[2]; };
    VECTOR(int2, int, 2)
    int2(int a, int b) : x(a), y(b) {}
};

struct uint2 {
    explicit uint2(int2 a) : x(uint(a.x)), y(uint(a.y)) {}
    union { struct { uint x, y; }; uint data[2]; };
    VECTOR(uint2, uint, 2)
    uint2(uint a, uint b) : x(a), y(b) {}
};

struct uint4 {
    struct XYZW { using Scalar = uint; static constexpr int SIZE = 4; };
    union {
        struct { uint x, y, z, w; };
        uint data[4];
        Swizzle<XYZW, uint2, 0, 1> xy;
        Swizzle<XYZW, uint2, 2, 3> zw;
    };
    VECTOR(uint4, uint, 4)
    OPERATOR(uint4, ^)
    OPERATOR(uint4, >>)
    uint4(uint a, uint b, uint c, uint d) : x(a), y(b), z(c), w(d) {}
    uint4(uint2 a, uint b, uint c) : x(a.x), y(a.y), z(b), w(c) {}
    uint4(uint2 a, uint2 b) : x(a.x), y(a.y), z(b.x), w(b.y) {}
};

// A matrix by its columns.
template <class Column, int N>
struct Matrix {
    Column columns[N];
    Matrix() : columns{} {}
    template <class... C>
    Matrix(Column first, C... rest) : columns{first, rest...} {}
    Column& operator[](int k) { return columns[k]; }
    const Column& operator[](int k) const { return columns[k]; }
};
struct float2x2 : Matrix<float2, 2> {
    using Matrix::Matrix;
    float2x2() = default;
    float2x2(float a, float b, float c, float d) : Matrix(float2(a, b), float2(c, d)) {}
};
using float2x3 = Matrix<float3, 2>;
using float3x3 = Matrix<float3, 3>;

inline float abs(float x) { return std::fabs(x); }
inline float sqrt(float x) { return std::sqrt(x); }
inline float4 sqrt(float4 a) {
    return float4(std::sqrt(a.x), std::sqrt(a.y), std::sqrt(a.z), std::sqrt(a.w));
}
template <class V, int N>
inline V select(V a, V b, Bools<N> second) {
    for (int k = 0; k < N; k++) a.data[k] = second.data[k] ? b.data[k] : a.data[k];
    return a;
}
inline uint min(uint a, uint b) { return a < b ? a : b; }
inline int min(int a, int b) { return a < b ? a : b; }
inline float clamp(float x, float low, float high) { return x < low ? low : x > high ? high : x; }
inline int select(int a, int b, bool second) { return second ? b : a; }
inline int ctz(int x) { return x == 0 ? 32 : __builtin_ctz(x); }

}  // namespace metal

// The bits of a number as one of another type.
template <class To, class From>
inline To as_type(From from) {
    To to;
    std::memcpy(&to, &from, sizeof(to));
    return to;
}
