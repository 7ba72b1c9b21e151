// Descriptions held to their tables.
#pragma once

#include "gpu/field_error.h"

namespace seaglass {

/// Whether a row is that of a member.
template<auto member>
bool isOf(const Field& field) {
    return field.get == &FieldAccess<member>::get;
}

/// Whether the table's first field is one that reads this one.
bool isRead(const FieldTable& table, const Field& field, const void* desc);

/// The line about a field that holds what it may not. `owner`: the description's name in what is said.
FieldError refused(const char* owner, const Field& field);

/// The first field that holds what it may not.
FieldError badField(const FieldTable& table, const void* desc);

/// The same of those that `reads` passes.
template<typename Reads>
FieldError badField(const FieldTable& table, const void* desc, const char* owner, const Reads& reads) {
    for (const Field& field : table)
        if (reads(field) && !isInRange(field, desc)) return refused(owner, field);
    return {};
}

} // namespace seaglass
