// SPDX-License-Identifier: Apache-2.0
// A badge of a certificate, in the form that shields.io asks for: https://shields.io/badges/endpoint-badge
#pragma once

#include <string>

#include "certify/adapter_run.h"
#include "certify/certificate.h"
#include "certify/report.h"

namespace toolcomp::certify {

// {"schemaVersion":1,"label":"toolcomp","message":"conforms in 13 sections","color":"brightgreen"}: one line, no more
// than the certificate says. Green only with exit status 0, and not the brightest where cases differ by design; red
// with findings, and where a self-check failed; yellow where not all was decided or judged; grey where nothing was.
std::string badge_json(const Certificate& certificate);
std::string badge_json(const TraceReport& report);
std::string badge_json(const AdapterCertificate& certificate);

// What stands there until the certificate is made: grey, "not finished". A run that is killed leaves it.
std::string unfinished_badge();

}  // namespace toolcomp::certify
