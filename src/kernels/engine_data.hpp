// What the stages of the vector renderer hand on: plain data that crosses between the driver and the
// kernels of every instruction set.
//
//     clusters --set-up--> batches of faces, lists a tile --raster--> depth and refs of a tile
//              --resolve--> surface points --illuminate--> radiance --encode--> bytes
#pragma once

#include "kernels/batches.hpp"
#include "kernels/lit.hpp"
#include "kernels/setup.hpp"
#include "kernels/surface.hpp"
#include "kernels/tile.hpp"
