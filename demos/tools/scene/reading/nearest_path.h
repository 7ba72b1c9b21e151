#pragma once

#include <string>

namespace demos::reading {

/// The nearest known path; of equally near ones, one in the same section.
std::string nearestPath(const std::string& schemaPath);

} // namespace demos::reading
