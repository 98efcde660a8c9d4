// Test cases for the search for installation paths, most of them built from boxes: channels,
// tunnels with corners, slots that require a turn, hooks, sealed boxes, gaps that are too small,
// parts that touch. In: a seed for sizes and for the frame in which everything lies. Units: mm.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "swept/types.h"

namespace swept::test {

struct PathCase {
  std::string name;
  TriMesh part;  ///< in its own coordinate system
  Pose start, goal;
  std::vector<TriMesh> neighbours;
  double clearance = 0;
  double release = 0;
  bool possible = true;    ///< a path exists
  bool needsTurn = false;  ///< no path exists without turning
};

/// A peg deep in a square channel that is open at one end.
PathCase channelCase(unsigned seed);
/// A block in a tunnel with one corner.
PathCase cornerCase(unsigned seed);
/// A bar lies behind a plate with a slot, across the slot. It must turn to get out.
PathCase slotCase(unsigned seed);
/// A hook around a bar: it gets out by turning and shifting at the same time.
PathCase hookCase(unsigned seed);
/// An L-shaped part in an L-shaped tunnel that it can only pass by turning in the corner.
PathCase elbowCase(unsigned seed);
/// A block in a closed box.
PathCase sealedCase(unsigned seed);
/// A channel whose mouth is narrower than the part.
PathCase narrowCase(unsigned seed);
/// A block that stands on a floor between two walls and touches all three.
PathCase touchingCase(unsigned seed);
/// Start and goal among some scattered boxes.
PathCase scatteredCase(unsigned seed);

/// Returns a case of the kinds above. Successive numbers go through all kinds and then change the
/// seed.
PathCase pathCase(unsigned number);

/// A T-shaped key in a T-slot that is open at one end.
PathCase keyCase(unsigned seed);
/// A square ring over a rod with two right bends.
PathCase ringCase(unsigned seed);
/// A U-shaped handle that has to be threaded through a window.
PathCase handleCase(unsigned seed);
/// A pin with a head in a keyhole.
PathCase keyholeCase(unsigned seed);
/// Two open hooks that hang in each other.
PathCase hooksCase(unsigned seed);
/// A round ring on a round shaft with two bends.
PathCase nutCase(unsigned seed);
/// A drawer with a stop that has to be lifted over an edge.
PathCase drawerCase(unsigned seed);
/// A block in a bay, under a beam.
PathCase engineCase(unsigned seed);

/// Returns a case of one of the kinds from keyCase() on. Successive numbers go through these kinds.
PathCase hardPathCase(unsigned number);

}  // namespace swept::test
