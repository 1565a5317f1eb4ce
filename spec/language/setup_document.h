// The tree of a setup to a Setup. Internal to the readers of setups and cases.
#pragma once

#include "spec/language/document.h"
#include "spec/language/setup.h"

namespace toolcomp::spec {

Setup setup_from(const document::Node& node, const document::Reader& read);

}  // namespace toolcomp::spec
