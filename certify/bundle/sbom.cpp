// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/sbom.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "certify/components.h"

namespace toolcomp::certify::bundle {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kUnknown = "NOASSERTION";

// "SPDXRef-" and letters, digits, '.' and '-'.
std::string reference(std::string_view name) {
  std::string id = "SPDXRef-";
  for (const char c : name) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
    id += plain ? c : '-';
  }
  return id;
}

// A part of a package URL.
std::string percent_encoded(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                       c == '-' || c == '_' || c == '~';
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

Json package(const std::string& id, std::string_view name, std::string_view version) {
  Json json{{"SPDXID", id}, {"name", name}};
  if (!version.empty()) json["versionInfo"] = version;
  json["downloadLocation"] = kUnknown;
  json["filesAnalyzed"] = false;
  json["licenseConcluded"] = kUnknown;
  json["licenseDeclared"] = kUnknown;
  json["copyrightText"] = kUnknown;
  return json;
}

Json relationship(const std::string& from, const char* type, const std::string& to) {
  return {{"spdxElementId", from}, {"relationshipType", type}, {"relatedSpdxElement", to}};
}

}  // namespace

std::string sbom(const std::string& made, const std::string& tool_hash) {
  const std::string document = "SPDXRef-DOCUMENT";
  const std::string tool = reference("toolcomp");
  Json json{{"spdxVersion", "SPDX-2.3"},
            {"dataLicense", "CC0-1.0"},
            {"SPDXID", document},
            {"name", "toolcomp " TOOLCOMP_VERSION},
            {"documentNamespace", "https://spdx.org/spdxdocs/toolcomp-" TOOLCOMP_VERSION "-" +
                                      (tool_hash.empty() ? percent_encoded(made) : tool_hash)},
            {"creationInfo", {{"created", made}, {"creators", {"Tool: toolcomp-" TOOLCOMP_VERSION}}}}};
  Json main = package(tool, "toolcomp", TOOLCOMP_VERSION);
  main["primaryPackagePurpose"] = "APPLICATION";
  main["comment"] = fmt::format("compiled by {}", kCompiler);
  if (!tool_hash.empty()) main["checksums"] = Json::array({{{"algorithm", "SHA256"}, {"checksumValue", tool_hash}}});
  json["packages"] = Json::array({main});
  json["relationships"] = Json::array({relationship(document, "DESCRIBES", tool)});
  for (const Component& component : kComponents) {
    const std::string id = reference(component.package);
    Json library = package(id, component.name, component.version);
    library["primaryPackagePurpose"] = "LIBRARY";
    if (component.debian) {
      library["supplier"] = "Organization: Debian";
      library["externalRefs"] =
          Json::array({{{"referenceCategory", "PACKAGE-MANAGER"},
                        {"referenceType", "purl"},
                        {"referenceLocator",
                         fmt::format("pkg:deb/debian/{}@{}", component.package, percent_encoded(component.version))}}});
    }
    json["packages"].push_back(std::move(library));
    json["relationships"].push_back(relationship(tool, "DEPENDS_ON", id));
  }
  return json.dump(2) + "\n";
}

}  // namespace toolcomp::certify::bundle
