// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "Vstage_reciprocal_16.h"
#include "Vstage_reciprocal_32.h"
#include "Vstage_reciprocal_6.h"
#include "pipeline_model.hpp"

namespace halfspace {
namespace {

const std::array kVariants{
    PipelineVariant{"area", kFull, 32, 32, make_pipeline<Vstage_reciprocal_32>},
    PipelineVariant{"perspective", kFull, 16, 8, make_pipeline<Vstage_reciprocal_16>},
    PipelineVariant{"least", kFull, 6, 2, make_pipeline<Vstage_reciprocal_6>}};

}  // namespace

std::span<const PipelineVariant> reciprocal_stages() { return kVariants; }

}  // namespace halfspace
