// Tamis: every contact between moving, deforming triangle meshes.
#pragma once
#include "tamis/contact.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"
#include "tamis/mesh.hpp"
#include "tamis/options.hpp"
#include "tamis/pair.hpp"
#include "tamis/path.hpp"
#include "tamis/reduced_model.hpp"
#include "tamis/rigid_path.hpp"
#include "tamis/spline_path.hpp"
#include "tamis/statistics.hpp"
#include "tamis/step.hpp"
