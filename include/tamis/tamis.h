/* Tamis for C, and for every language that can call C: contacts between moving, deforming triangle meshes.
 *
 * Handles are opaque. Calls that make or query something return a status. The handle keeps the status's message until
 * the next call with it. A failed call that makes a handle writes one, too, to read the message from (unless memory ran
 * out: then NULL): free it in either case. Freeing NULL does nothing. Nothing is thrown across this interface.
 *
 * Structs begin with their size: set it to sizeof, the rest to zero, then the fields that you need. So structs may
 * grow, and an older program still runs with a newer library: fields that the program does not know have their
 * defaults, and fields that the library does not know must be zero.
 *
 * Arrays and strings that are given are read during the call alone. One handle serves one thread at a time; a call with
 * a detector or world that is still answering returns TAMIS_BUSY. Different handles are independent.
 *
 * This header includes all parts: meshes, detectors for questions about them, single pairs, curved motion, and worlds
 * of bodies. */
#ifndef TAMIS_TAMIS_H
#define TAMIS_TAMIS_H

#include "tamis/c/answers.h"
#include "tamis/c/detector.h"
#include "tamis/c/linkage.h"
#include "tamis/c/mesh.h"
#include "tamis/c/pairs.h"
#include "tamis/c/path.h"
#include "tamis/c/status.h"
#include "tamis/c/world.h"

#endif
