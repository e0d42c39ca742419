/* Tamis for C, and for every language that can call C: contacts between moving, deforming triangle meshes.
 *
 * Handles are opaque. Whatever makes or asks something returns a status; its sentence stands in the handle until the
 * next call with it. A call that makes a handle writes one even if it fails, to read the sentence from, unless memory
 * ran out (then NULL): free it in either case. Freeing NULL does nothing. Nothing is thrown across this interface.
 *
 * Structs begin with their size: set it to sizeof, the rest to zero, then what you need. So they may grow, and an older
 * program still runs with a newer library: what a caller does not know of is left as it is by default, and what the
 * library does not know of must be zero.
 *
 * Pointers that are given are read during the call alone. One handle serves one thread at a time; calls at once with
 * a detector that is asking give TAMIS_BUSY. Different handles are independent.
 *
 * All of it is here; the parts: a mesh, a detector that asks about it, single pairs, curved motion,
 * and worlds of bodies. */
#ifndef TAMIS_TAMIS_H
#define TAMIS_TAMIS_H

#include "tamis/c/answers.h"
#include "tamis/c/detector.h"
#include "tamis/c/mesh.h"
#include "tamis/c/pairs.h"
#include "tamis/c/path.h"
#include "tamis/c/status.h"
#include "tamis/c/world.h"

#endif
