// SPDX-License-Identifier: Apache-2.0
// Every intermediate double of the trace judge and of the oracle, one of which is made NaN or an infinity (poison.py).
#pragma once

#include <set>

namespace toolcomp::poison {

inline int chosen = -1;
inline double instead = 0;
inline std::set<int>* reached = nullptr;

inline double here(int place, double value) {
  if (reached != nullptr) reached->insert(place);
  return place == chosen ? instead : value;
}

}  // namespace toolcomp::poison
