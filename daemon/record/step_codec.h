#pragma once
// A StepRecord as bytes, exactly: the channel /step of a recording. Little-endian, packed, in the
// order of step_fields.h: integers of their size, doubles as IEEE 754, truth values and
// enumerations as one byte, a list as u32 count and its entries. The channel /before has the inputs
// alone, of many steps in one block: each as u32 size and its fields. Pure.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/step_record.h"

namespace tp100::record {

/// Far above anything that a robot measures; larger values would make sums meaningless.
inline constexpr double kMaxInput = 1e9;
inline constexpr std::int64_t kLongestTime = std::int64_t{1} << 60;

/// Appends `record` to `out`.
void encode_step(const StepRecord& record, std::vector<std::uint8_t>& out);

/// Decodes all of `bytes` into `record`; entries beyond the counts stay unchanged. Returns nothing
/// on success, else the error: too few or too many bytes, a count, enumeration or boolean out of
/// range, a time beyond kLongestTime, impossible inputs (not finite, beyond kMaxInput). Numbers
/// among the results may have any value.
std::optional<std::string> decode_step(std::span<const std::uint8_t> bytes, StepRecord& record);

/// Appends the inputs of `record`, with their size, to a block.
void encode_inputs(const StepRecord& record, std::vector<std::uint8_t>& block);

/// Decodes the first step of `block` into the inputs of `record`, and removes it from `block`.
/// Returns an error like decode_step.
std::optional<std::string> decode_inputs(std::span<const std::uint8_t>& block, StepRecord& record);

/// The layout as JSON: {"encoding": ..., "fields": [[name, type], ...]}. Two programs understand
/// each other's records if these texts are equal.
const std::string& step_schema();
const std::string& inputs_schema();

}  // namespace tp100::record
