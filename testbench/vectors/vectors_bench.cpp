// SPDX-License-Identifier: Apache-2.0
#include "vectors_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/config_package.hpp"
#include "vectors_bench_text.hpp"

namespace halfspace {
namespace {

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// A stage with valid and ready, or the grid, which has neither: it gets a register that says so.
std::string dut_text(const VectorMeta& meta) {
  if (meta.stage == VectorStage::kHalfPlaneGrid) {
    return fmt::format(
        "  reg  full_q;\n"
        "  wire load;\n"
        "  assign ready_o = !full_q || ready_i;\n"
        "  assign valid_o = full_q;\n"
        "  assign busy_o  = full_q;\n"
        "  assign load    = valid_i && ready_o;\n"
        "  always @(posedge clk_i) full_q <= rst_ni && (load || (full_q && !ready_i));\n"
        "  hs_half_plane_grid u_dut (\n"
        "`ifdef HS_MUTSEL\n    .mutsel(mutsel),\n`endif\n"
        "    .clk_i(clk_i), .load_i(load), .base_i(in_i[{0}-1:{1}]), .slope_i(in_i[{1}-1:0]),\n"
        "    .ab_o(out_o[{2}-1:{3}]), .covered_o(out_o[{3}-1:0]));",
        layout_bits(grid_in_layout(meta.config)), 2 * meta.config.delta_bits(),
        layout_bits(grid_out_layout(meta.config)), meta.config.lanes());
  }
  const char* in = "triangle_i";
  const char* out = "coverage_o";
  bool frame = true;
  if (meta.stage == VectorStage::kTriangleSetup) out = "setup_o";
  if (meta.stage == VectorStage::kTileTraversal) in = "node_i", out = "node_o", frame = false;
  if (meta.stage == VectorStage::kCoverage) in = "tile_i", frame = false;
  const bool level = meta.stage == VectorStage::kTileTraversal;
  return fmt::format(
      "`ifdef HS_NETLIST\n  hs_{0} u_dut (\n`else\n  hs_{0} {1}u_dut (\n`endif\n"
      "`ifdef HS_MUTSEL\n    .mutsel(mutsel),\n`endif\n"
      "    .clk_i(clk_i), .rst_ni(rst_ni), {2}.busy_o(busy_o),\n"
      "    .valid_i(valid_i), .ready_o(ready_o), .{3}(in_i),\n"
      "    .valid_o(valid_o), .ready_i(ready_i), .{4}(out_o));",
      stage_name(meta.stage), level ? fmt::format("#(.Level({})) ", meta.level) : "",
      frame ? ".frame_i(frame_i), " : "", in, out);
}

// Every @NAME@ of the text.
std::string filled(std::string text, const VectorSet& set) {
  const VectorMeta& meta = set.meta;
  const VectorCounts counts = count_records(set);
  const auto bits = [&](RecordKind kind) { return layout_bits(vector_layout(kind, meta)); };
  const bool clocked = meta.stage == VectorStage::kRasterizer;
  std::size_t words = 0;
  for (const VectorRecord& record : set.records) {
    if (record.kind == RecordKind::kRun) words += ready_words(record.values);
  }
  const std::string top = fmt::format("hs_{}", stage_name(meta.stage));
  const std::string level = meta.stage == VectorStage::kTileTraversal
                                ? fmt::format(" -chparam Level {}", meta.level)
                                : "";
  const std::string fields =
      clocked ? "      offer = in[InBits-33 -: 32];\n      accept = in[InBits-65 -: 32];\n"
                "      due = out[OutBits-1 -: 32];"
              : "      offer = 0;\n      accept = 0;\n      due = 0;";
  const int out_bits = bits(RecordKind::kOut);
  const std::array<std::pair<const char*, std::string>, 17> values{
      {{"@PROGRAM@", meta.program},
       {"@STAGE@", std::string(stage_name(meta.stage))},
       {"@RUN_BITS@", std::to_string(bits(RecordKind::kRun))},
       {"@IN_BITS@", std::to_string(bits(RecordKind::kIn))},
       {"@OUT_BITS@", std::to_string(out_bits)},
       {"@FRAME_BITS@", std::to_string(layout_bits(frame_layout(meta.config)))},
       {"@IN_PORT@", std::to_string(bits(RecordKind::kIn) - (clocked ? 96 : 32))},
       {"@OUT_PORT@", std::to_string(out_bits - (clocked ? 32 : 0))},
       {"@RUNS@", std::to_string(counts.runs)},
       {"@INPUTS@", std::to_string(counts.inputs)},
       {"@OUTPUTS@", std::to_string(counts.outputs)},
       {"@READY_WORDS@", std::to_string(std::max<std::size_t>(words, 1))},
       {"@CLOCKED@", clocked ? "1" : "0"},
       {"@CLOCK_FIELDS@", fields},
       {"@DUT@", dut_text(meta)},
       {"@HIERARCHY@", "-top " + top + level},
       {"@TOP@", top}}};
  for (const auto& [name, value] : values) text = replace_all(std::move(text), name, value);
  return text;
}

}  // namespace

std::vector<NamedBytes> vector_bench(const VectorSet& set) {
  std::vector<NamedBytes> files = vector_files(set, VectorFormat::kReadmemh, "vectors.hex");
  files.push_back({"hs_vectors_tb.sv", filled(kBenchText, set)});
  files.push_back({"hs_vectors_dut.sv", filled(kDutText, set)});
  files.push_back({"hs_config_pkg.sv", config_package(set.meta.config, "manifest.json beside it")});
  files.push_back({"run_icarus.sh", filled(kIcarusText, set), true});
  files.push_back({"run_verilator.sh", filled(kVerilatorText, set), true});
  files.push_back({"Makefile", filled(kMakefileText, set)});
  files.push_back(vector_manifest(set, files, "manifest.json"));
  return files;
}

}  // namespace halfspace
