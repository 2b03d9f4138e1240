// The representations of a convex polyhedron: what some searches walk on, made when it is first asked for and shared
// by all copies of the polyhedron.
//
//   represent::of<Drums>(body)
//
// A representation is a type T with a number of its own, T::slot < LazySlots::count, and T::make(body), which may throw
// Error. The polyhedron knows none of them: a new one edits no object.
#pragma once

#include <sunder/base/error.h>
#include <sunder/base/lazy_slots.h>
#include <sunder/solid/object/convex_polyhedron.h>

namespace sunder::solid::represent {

// Requires what T::make requires, and throws what it throws. Valid as long as a copy of the polyhedron lives.
template <class T>
const T& of(const ConvexPolyhedron& body) {
  return body.slots().get<T>(T::slot, [&] { return T::make(body); });
}

}  // namespace sunder::solid::represent
