/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * All of Filigree: the core (libfiligree), file formats (libfiligree_io) and picking (libfiligree_pick). */
#ifndef FILIGREE_FILIGREE_ALL_H
#define FILIGREE_FILIGREE_ALL_H

#include "filigree_bake.h"
#include "filigree_brush.h"
#include "filigree_buffers.h"
#include "filigree_io.h"
#include "filigree_live.h"
#include "filigree_motion.h"
#include "filigree_pick.h"
#include "filigree_project.h"
#include "filigree_pull.h"
#include "filigree_rig.h"
#include "filigree_debug.h"

#endif
