// Defines fieldsOf() for the files that say which descriptions have a table.
#pragma once

#include "seaglass/fields.h"

namespace seaglass {

/// A description's table.
template<typename Desc>
inline constexpr FieldTable tableOf{};

template<typename Desc>
FieldTable fieldsOf(const Desc&) {
    return tableOf<Desc>;
}

} // namespace seaglass
