// Vectors of numbers of any type that has +, - and *: doubles, intervals, exact numbers.
#pragma once

namespace sunder {

template <class T>
struct Vector2 {
  T x, y;
};

template <class T>
struct Vector3 {
  T x, y, z;
};

template <class T, class U>
auto operator+(const Vector2<T>& a, const Vector2<U>& b) {
  return Vector2<decltype(a.x + b.x)>{a.x + b.x, a.y + b.y};
}
// Always inlined, so that intervals that are points are subtracted as points (see interval.h).
template <class T, class U>
[[gnu::always_inline]] inline auto operator-(const Vector2<T>& a, const Vector2<U>& b) {
  return Vector2<decltype(a.x - b.x)>{a.x - b.x, a.y - b.y};
}
template <class T>
Vector2<T> operator-(const Vector2<T>& a) {
  return {-a.x, -a.y};
}
template <class T, class U>
auto cross(const Vector2<T>& a, const Vector2<U>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class T, class U>
auto dot(const Vector2<T>& a, const Vector2<U>& b) {
  return a.x * b.x + a.y * b.y;
}

template <class T, class U>
auto operator-(const Vector3<T>& a, const Vector3<U>& b) {
  return Vector3<decltype(a.x - b.x)>{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T, class U>
auto cross(const Vector3<T>& a, const Vector3<U>& b) {
  return Vector3<decltype(a.y * b.z - a.z * b.y)>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T, class U>
auto dot(const Vector3<T>& a, const Vector3<U>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace sunder
