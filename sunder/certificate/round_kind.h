// The kinds of bodies with a radius, as certificate files know them (docs/claims.md, "Tables").
#pragma once

#include <sunder/predicate/disc/round_kind.h>
