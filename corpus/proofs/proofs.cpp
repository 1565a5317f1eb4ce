#include "corpus/proofs/proofs.h"

#include <fmt/format.h>

#include "corpus/golden.h"
#include "spec/language/file_writer.h"

namespace toolcomp::corpus {
namespace {

struct Section {
  const char* section;
  const char* file;
  std::vector<Lemma> (*lemmas)(const spec::Case&);
};
constexpr Section kSections[] = {
    {"fanuc/tool-length-offset", "GoldenToolLengthOffset.v", length_offset_lemmas},
    {"fanuc/tool-length-measurement", "GoldenToolLengthMeasurement.v", length_measurement_lemmas},
    {"fanuc/tool-offset", "GoldenToolOffset.v", tool_offset_lemmas},
    {"fanuc/cutter-compensation-b", "GoldenCutterCompensationB.v", cutter_b_lemmas},
    {"fanuc/leading-edge-offset", "GoldenLeadingEdgeOffset.v", leading_edge_lemmas},
    {"fanuc/cutter-compensation-c", "GoldenCutterCompensationC.v", cutter_compensation_c_lemmas},
    {"fanuc/tool-side-compensation", "GoldenToolSideCompensation.v", tool_side_lemmas},
    {"fanuc/tool-center-point-control", "GoldenToolCenterPointControl.v", tool_center_point_lemmas},
    {"fanuc/tool-posture-control", "GoldenToolPostureControl.v", tool_posture_lemmas},
    {"heidenhain/face-milling", "GoldenFaceMilling.v", face_milling_lemmas},
    {"heidenhain/peripheral-milling", "GoldenPeripheralMilling.v", peripheral_milling_lemmas},
    {"heidenhain/programmed-contour", "GoldenProgrammedContour.v", programmed_contour_lemmas},
};

ProofFile write(const Section& section, const std::vector<Vector>& vectors, const std::filesystem::path& output,
                const ProofOptions& options) {
  ProofFile written{output / section.file, 0, 0};
  std::string text = fmt::format(
      "(** Generated from the golden vectors of {}. *)\nFrom Coq Require Import Reals Lra List.\n"
      "From Toolcomp Require Import Vectors LeadingEdgeOffset ToolLengthOffset ToolDirection Golden.\n"
      "From Toolcomp Require ToolLengthMeasurement ToolOffset CutterCompensationB CutterCompensationC "
      "ToolSideCompensation FaceMilling PeripheralMilling ProgrammedContour.\n"
      "Import ListNotations.\nOpen Scope R_scope.\n",
      section.section);
  std::size_t computed = 0;
  std::size_t intervals = 0;
  for (const Vector& vector : vectors) {
    if (vector.c.section != section.section) continue;
    std::size_t taken = 0;
    for (const Lemma& lemma : section.lemmas(vector.c)) {
      std::size_t& count = lemma.by_intervals ? intervals : computed;
      if (taken == options.a_vector || count == (lemma.by_intervals ? options.intervals : options.computed)) continue;
      ++taken;
      ++count;
      text += '\n' + lemma.text;
    }
    written.lemmas += taken;
    if (taken != 0) ++written.vectors;
  }
  spec::write_file(written.file, text);
  return written;
}

}  // namespace

std::vector<ProofFile> write_proofs(const std::filesystem::path& corpus, const std::filesystem::path& output,
                                    const ProofOptions& options) {
  const std::vector<Vector> vectors = read_vectors(corpus);
  std::vector<ProofFile> files;
  for (const Section& section : kSections) files.push_back(write(section, vectors, output, options));
  return files;
}

}  // namespace toolcomp::corpus
