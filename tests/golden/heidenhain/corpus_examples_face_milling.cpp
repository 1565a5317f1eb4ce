// SPDX-License-Identifier: Apache-2.0
// The vectors of face milling hold the figures of the worked examples E1 to E28 and the table of oversize verdicts, to
// the last digit typed in. All of them, and the figures of the rules, are by hand from the formulas of the clauses
// (3-4-5 vectors: all rational), checked by a computation with 70 digits that shares nothing with the engines.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/golden/heidenhain/space_rows.h"

namespace toolcomp::corpus {
namespace {

constexpr const char* kSection = "heidenhain/face-milling";

TEST(FaceMillingVectors, Examples) {
  const std::vector<worked::Example> table = {
      {"E1: a ball of 6 mm",
       {"3 programmed tip=36.054981069776461,6.24258845869536,-1.933902321076868 "
        "shift=0.046581069776461,0.06558845869536,-0.013002321076868 "
        "axes=36.054981069776461,6.24258845869536,-1.933902321076868 "
        "center=36.054981069776461,8.144653760860809,0.255195115379139 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 contact=37.405832093293828,8.144653760860809,-2.310969632306029 "
        "feed=1000"}},
      {"E2: the same tool,",
       {"3 programmed tip=36.054981069776461,4.274934697834551,-4.198485876031357 "
        "shift=0.046581069776461,0.06558845869536,-0.013002321076868 "
        "axes=36.054981069776461,4.274934697834551,-4.198485876031357 "
        "center=36.054981069776461,6.177,-2.009388439575351 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 carrier=36.054981069776461,56.745701654122795,56.190408922755032 "
        "contact=37.405832093293828,6.177,-4.575553187260518 feed=1000"}},
      {"E3: an oversize of",
       {"3 programmed tip=35.915237860447078,6.045823082609279,-1.894895357846265 "
        "shift=-0.093162139552922,-0.131176917390721,0.026004642153735 tool=-0.093162139552922,0,0.176976879150701 "
        "axes=35.915237860447078,6.177,-1.743923120849299 "
        "center=35.915237860447078,8.144653760860809,0.520660434105191 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 contact=37.405832093293828,8.144653760860809,-2.310969632306029 "
        "feed=1000"}},
      {"E3 without M107: E", {"2 E_OVERSIZE_DR"}},
      {"E4: the same oversize",
       {"4 programmed tip=35.915237860447078,4.07816932174847,-4.159478912800754 "
        "shift=-0.093162139552922,-0.131176917390721,0.026004642153735 tool=-0.093162139552922,0,0.176976879150701 "
        "axes=35.915237860447078,4.209346239139191,-4.008506675803788 "
        "center=35.915237860447078,6.177,-1.743923120849299 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 contact=37.405832093293828,6.177,-4.575553187260518 feed=1000"}},
      {"E5: block 12, without",
       {"2 programmed tip=36.054981069776461,6.177,-1.909388439575351 shift=0.046581069776461,0,0.011511560424649 "
        "axes=36.054981069776461,6.177,-1.909388439575351 center=36.054981069776461,6.177,0.990611560424649 "
        "normal=-0.465810697764609,0,0.884884395753506 contact=37.405832093293828,6.177,-1.575553187260518 feed=1000"}},
      {"E5 with the oversize",
       {"3 programmed tip=35.915237860447078,6.177,-1.943923120849299 shift=-0.093162139552922,0,-0.023023120849299 "
        "tool=-0.093162139552922,0,0.176976879150701 axes=35.915237860447078,6.177,-1.743923120849299 "
        "center=35.915237860447078,6.177,1.256076879150701 normal=-0.465810697764609,0,0.884884395753506 "
        "contact=37.405832093293828,6.177,-1.575553187260518 feed=1000"}},
      {"E6: block 14, under",
       {"2 programmed tip=36.0084,6.177,-1.9209 shift=0,0,0 axes=36.0084,6.177,-1.9209 "
        "center=34.657548976482633,6.177,0.645264747685168 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=-0.465810697764609,0,0.884884395753506 contact=36.0084,6.177,-1.9209 feed=1000 flat"}},
      {"E6 with the oversize",
       {"3 programmed tip=36.0084,6.177,-1.9209 shift=0,0,0 tool=-0.093162139552922,0,0.176976879150701 "
        "axes=35.915237860447078,6.177,-1.743923120849299 center=34.51780576715325,6.177,0.91073006641122 "
        "normal=-0.465810697764609,0,0.884884395753506 axis=-0.465810697764609,0,0.884884395753506 "
        "contact=36.0084,6.177,-1.9209 feed=1000 flat"}},
      {"E7: block 11, a straight",
       {"2 programmed tip=36.0084,6.177,-1.9209 shift=0,0,0 tool=0,0,0.2 axes=36.0084,6.177,-1.7209 "
        "center=36.0084,6.177,1.2791 feed=1000"}},
      {"5.10 without a normal: TCP",
       {"2 programmed tip=1,2,3 shift=0,0,0 tool=0,0,0.05 axes=1,2,3.05 center=1,2,3.98", "3 W_NO_LATERAL",
        "3 programmed tip=1,2,3 shift=0,0,0 axes=1,2.03,3.04 center=1,2.588,3.784 axis=0,0.6,0.8"}},
      {"5.10 without a normal under",
       {"3 programmed tip=1,2,2 shift=0,0,0 tool=0,0,0.05 axes=1,2,2.05 center=1,2,2.98"}},
      {"E7, E5, E1 and E6 one",
       {"5 rapid programmed tip=0,0,100 shift=0,0,0 axes=0,0,100 center=0,0,102.9",
        "6 programmed tip=36.0084,6.177,-1.9209 shift=0,0,0 axes=36.0084,6.177,-1.9209 center=36.0084,6.177,0.9791 "
        "feed=1000",
        "7 programmed tip=36.054981069776461,6.177,-1.909388439575351 shift=0.046581069776461,0,0.011511560424649 "
        "axes=36.054981069776461,6.177,-1.909388439575351 center=36.054981069776461,6.177,0.990611560424649 "
        "normal=-0.465810697764609,0,0.884884395753506 contact=37.405832093293828,6.177,-1.575553187260518 feed=1000",
        "8 programmed tip=36.054981069776461,6.24258845869536,-1.933902321076868 "
        "shift=0.046581069776461,0.06558845869536,-0.013002321076868 "
        "axes=36.054981069776461,6.24258845869536,-1.933902321076868 "
        "center=36.054981069776461,8.144653760860809,0.255195115379139 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 contact=37.405832093293828,8.144653760860809,-2.310969632306029 "
        "feed=1000",
        "9 programmed tip=36.0084,6.177,-1.9209 shift=0,0,0 axes=36.0084,6.177,-1.9209 "
        "center=34.657548976482633,6.177,0.645264747685168 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=-0.465810697764609,0,0.884884395753506 contact=36.0084,6.177,-1.9209 feed=1000 flat",
        "10 rapid programmed tip=36.0084,6.177,100 shift=0,0,0 axes=36.0084,6.177,100 "
        "center=34.657548976482633,6.177,102.566164747685168 axis=-0.465810697764609,0,0.884884395753506"}},
      {"E11: a toroid cutter",
       {"2 programmed tip=36.067790409959017,6.237213860946861,-1.964421433662979 "
        "shift=0.059390409959017,0.060213860946861,-0.043521433662979 "
        "tool=0.059390409959017,0.093008090294541,-0.005778374413738 "
        "axes=36.067790409959017,6.270008090294541,-1.926678374413738 "
        "center=36.067790409959017,6.879980756161392,-1.224657472377846 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 contact=39.603847947997413,9.776395162440404,-4.608483801244025 "
        "feed=1000"}},
      {"E11 under CNT-CNT.",
       {"3 programmed tip=36.067790409959017,5.581329273993258,-2.719282618647809 "
        "shift=0.059390409959017,0.060213860946861,-0.043521433662979 "
        "tool=0.059390409959017,0.093008090294541,-0.005778374413738 "
        "axes=36.067790409959017,5.614123503340938,-2.681539559398567 "
        "center=36.067790409959017,6.224096169207789,-1.979518657362676 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 contact=39.603847947997413,9.120510575486801,-5.363344986228855 "
        "feed=1000"}},
      {"E11 without TCPM: u",
       {"2 programmed tip=36.097716213955292,6.177,-1.91859768791507 shift=0.089316213955292,0,0.00230231208493 "
        "tool=0.089316213955292,0,0.05230231208493 axes=36.097716213955292,6.177,-1.86859768791507 "
        "center=36.097716213955292,6.177,-0.93859768791507 normal=-0.465810697764609,0,0.884884395753506 "
        "contact=41.474210697764609,6.177,-1.805784395753506 feed=1000"}},
      {"E11 in block 14: the",
       {"2 programmed tip=36.0084,6.177,-1.9209 shift=0,0,0 tool=-0.02329053488823,0,0.044244219787675 "
        "axes=35.98510946511177,6.177,-1.876655780212325 center=35.551905516190683,6.177,-1.053713292161564 "
        "normal=-0.465810697764609,0,0.884884395753506 axis=-0.465810697764609,0,0.884884395753506 "
        "contact=36.0084,6.177,-1.9209 feed=1000 flat"}},
      {"E13: normal and tool",
       {"3 programmed tip=10,20,5 shift=0,0,0 tool=0,0,0.05 axes=10,20,5.05 center=10,20,5.98 normal=0,0,1 "
        "contact=10,20,5 flat"}},
      {"E13 with a normal",
       {"3 programmed tip=10,20,5 shift=0,0,0 tool=0,0,0.05 axes=10,20,5.05 center=10,20,5.98 normal=0,0,1 "
        "contact=10,20,5 flat",
        "4 W_CONTACT_JUMP",
        "4 programmed tip=9.919999998,20,5 shift=-0.080000002,0,0 tool=-0.080000002,0,0.05 axes=9.919999998,20,5.05 "
        "center=9.919999998,20,5.98 normal=0.0000001,0,0.999999999999995 contact=4.9999999,20,5.000000000000005"}},
      {"E16: rational, 5/2",
       {"2 programmed tip=0.26,0,-0.02 shift=0.26,0,-0.02 tool=0.26,0,0.23 axes=0.26,0,0.23 center=0.26,0,2.08 "
        "normal=0.6,0,0.8 contact=-4.2,0,0.4"}},
      {"E21: DR2 0.3 alone",
       {"3 programmed tip=35.868656790670617,5.980234623913919,-1.881893036769397 "
        "shift=-0.139743209329383,-0.196765376086081,0.039006963230603 "
        "axes=35.868656790670617,5.980234623913919,-1.881893036769397 "
        "center=35.868656790670617,8.144653760860809,0.609148873680541 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 contact=37.405832093293828,8.144653760860809,-2.310969632306029"}},
      {"E23: sums of three",
       {"5 programmed tip=35.957160823245893,6.104852695435104,-1.906597446815446 "
        "shift=-0.051239176754107,-0.072147304564896,0.014302553184554 "
        "tool=-0.051239176754107,0.036073652282448,0.138854648707051 "
        "axes=35.957160823245893,6.213073652282448,-1.782045351292949 "
        "center=35.957160823245893,8.144653760860809,0.441020838487375 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 contact=37.405832093293828,8.144653760860809,-2.310969632306029"}},
      {"E25: an undercut, N",
       {"2 W_N_BELOW",
        "2 programmed tip=-0.06,0,0.18 shift=-0.06,0,0.18 axes=-0.06,0,0.18 center=-0.06,0,3.08 normal=0.6,0,-0.8 "
        "contact=-1.8,0,5.4"}},
      {"E27: a program in inches",
       {"3 W_DIGITS",
        "3 programmed tip=1.4194874003849,0.245771222783282,-0.076137902404601 "
        "shift=0.0018339003849,0.002582222783282,-0.000511902404601 "
        "axes=1.4194874003849,0.245771222783282,-0.076137902404601 "
        "center=1.4194874003849,0.320655683498457,0.010047036038549 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 contact=1.472670511547001,0.320655683498457,-0.090983072138033 "
        "feed=40"}},
      {"E28: output at the",
       {"2 programmed tip=36.054981069776461,6.24258845869536,-1.933902321076868 "
        "shift=0.046581069776461,0.06558845869536,-0.013002321076868 "
        "tool=0.046581069776461,-1.902065302165449,-2.277585876031357 "
        "axes=36.054981069776461,4.274934697834551,-4.198485876031357 "
        "center=36.054981069776461,8.144653760860809,0.255195115379139 normal=-0.465810697764609,0,0.884884395753506 "
        "axis=0,0.655884586953603,0.75486118498483 contact=37.405832093293828,8.144653760860809,-2.310969632306029"}},
      {"The manual's syntax",
       {"2 W_NOT_NORMALIZED", "2 W_NOT_NORMALIZED", "2 W_N_BELOW",
        "2 programmed tip=31.709046835115408,21.857242091505932,33.289096299579146 "
        "shift=-0.027953164884592,-0.096757908494068,0.124096299579146 "
        "axes=31.709046835115408,21.857242091505932,33.289096299579146 "
        "center=31.734089228254766,19.076268182524897,34.111019042975749 "
        "normal=0.288166956825006,0.008622564602393,-0.957541360137458 "
        "axis=0.008635307979089,-0.958956520338288,0.283421635654001 "
        "contact=30.898405053462248,19.051262745177959,36.887888987374377 feed=1000"}},
      {"The manual's table",
       {"2 programmed tip=0.003535533905933,0,-0.001464466094067 shift=0.003535533905933,0,-0.001464466094067 "
        "axes=0.003535533905933,0,-0.001464466094067 center=0.003535533905933,0,3.003535533905933 "
        "normal=0.707106781186548,0,0.707106781186548 contact=-2.121320343559643,0,0.878679656440357 angle=45"}},
      {"Oversize 3/3, DR -0.1,",
       {"4 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 axes=0.94,2,3.02 center=0.94,2,5.92 normal=0.6,0,0.8 "
        "contact=-0.8,2,3.6",
        "6 W_NO_LATERAL", "6 programmed tip=1,2,4 shift=0,0,0 axes=1,2,4 center=1,2,6.9",
        "7 programmed tip=0.94,2,5.02 shift=-0.06,0,0.02 axes=0.94,2,5.02 center=0.94,2,7.92 normal=0.6,0,0.8 "
        "contact=-0.8,2,5.6"}},
      {"Oversize 3/3, DR 0.2, DR2 0.2:",
       {"4 programmed tip=1.12,2,2.96 shift=0.12,0,-0.04 axes=1.12,2,2.96 center=1.12,2,6.16 normal=0.6,0,0.8 "
        "contact=-0.8,2,3.6",
        "6 E_OVERSIZE_DR"}},
      {"Oversize 3/3, DR 0.2, DR2 0.2 with", {"3 E_OVERSIZE_DR"}},
      {"Oversize 3/3, DR2 0",
       {"4 programmed tip=1.18,2,2.94 shift=0.18,0,-0.06 axes=1.18,2,2.94 center=1.18,2,6.24 normal=0.6,0,0.8 "
        "contact=-0.8,2,3.6",
        "6 W_NO_LATERAL", "6 programmed tip=1,2,4 shift=0,0,0 axes=1,2,4 center=1,2,7.3", "7 E_OVERSIZE_DR2"}},
      {"Oversize 3/3, DR -0.1:",
       {"4 programmed tip=1,2,3 shift=0,0,0 axes=1,2,3 center=1,2,6 normal=0.6,0,0.8 contact=-0.8,2,3.6",
        "6 W_NO_LATERAL", "6 programmed tip=1,2,4 shift=0,0,0 axes=1,2,4 center=1,2,7", "7 E_R2_GT_R"}},
      {"Oversize 3/3, DR2 -0",
       {"4 programmed tip=1.04,2,3.02 shift=0.04,0,0.02 axes=1.04,2,3.02 center=1.04,2,5.92 normal=0.6,0,0.8 "
        "contact=-0.8,2,3.6",
        "6 W_NO_LATERAL", "6 programmed tip=1,2,4 shift=0,0,0 axes=1,2,4 center=1,2,6.9",
        "7 programmed tip=1.04,2,5.02 shift=0.04,0,0.02 axes=1.04,2,5.02 center=1.04,2,7.92 normal=0.6,0,0.8 "
        "contact=-0.8,2,5.6"}},
      {"Oversize 6/0, DR -0",
       {"4 programmed tip=0.9,2,3 shift=-0.1,0,0 axes=0.9,2,3 normal=0.6,0,0.8 contact=-5,2,3", "6 W_NO_LATERAL",
        "6 programmed tip=1,2,4 shift=0,0,0 axes=1,2,4",
        "7 programmed tip=0.9,2,5 shift=-0.1,0,0 axes=0.9,2,5 normal=0.6,0,0.8 contact=-5,2,5"}},
      {"Oversize 6/1, DR2 -1.1 under", {"4 E_R2_NEG"}},
      {"Oversize 6/1, DR2 -1.1 with a", {"3 E_R2_NEG"}},
      {"Oversize 6/1, DR2 -1.1 without", {"3 E_R2_NEG"}},
      {"Oversize 6/1, DR -5",
       {"4 programmed tip=-4,2,3 shift=-5,0,0 axes=-4,2,3 center=-4,2,4 normal=0.6,0,0.8 contact=-4.6,2,3.2",
        "6 W_NO_LATERAL", "6 programmed tip=1,2,4 shift=0,0,0 axes=1,2,4 center=1,2,5", "7 E_R2_GT_R"}},
      {"Oversize 6/0, DR 0.2, DR2 0.2:",
       {"4 programmed tip=1.12,2,2.96 shift=0.12,0,-0.04 axes=1.12,2,2.96 center=1.12,2,3.16 normal=0.6,0,0.8 "
        "contact=-5,2,3",
        "6 E_OVERSIZE_DR"}},
      {"Oversize 6/0, DR 0.2, DR2 0.2 with", {"3 E_OVERSIZE_DR"}},
  };
  space::expect(kSection, "examples", table);
}

TEST(FaceMillingVectors, Rules) {
  const std::vector<worked::Example> table = {
      {"LN before any TOOL", {"1 programmed tip=5,0,0", "2 E_NO_TOOL"}},
      {"TOOL CALL 0 is a tool", {"2 programmed tip=1,2,3 contact=1,2,3"}},
      {"R -1 in the table:", {"2 programmed tip=5,0,0", "3 E_TOOL"}},
      {"R2 -1 in the table", {"2 E_TOOL"}},
      {"R2 beyond R in the", {"2 E_TOOL"}},
      {"An effective radius below", {"2 E_TOOL_EFF"}},
      {"An effective radius of", {"2 programmed tip=0,2,3 shift=-1,0,0 contact=0,2,3"}},
      {"An effective corner", {"2 programmed tip=1.4,2,3.2 shift=0.4,0,0.2 contact=-4.6,2,3.2"}},
      {"An oversize from", {"2 programmed tip=1,2,3 contact=-3.2,2,3.4", "4 E_OVERSIZE_DR"}},
      {"DL 5 is never oversize", {"2 programmed tip=1,2,3 tool=0,0,5 axes=1,2,8 carrier=1,2,108 contact=-3.2,2,3.4"}},
      {"M107 takes effect",
       {"2 programmed tip=1.1,2,3 shift=0.1,0,0 contact=-3.2,2,3.4",
        "3 programmed tip=1.1,2,3 shift=0.1,0,0 contact=-3.2,2,3.4", "4 E_OVERSIZE_DR"}},
      {"Deviations: exactly",
       {"2 programmed tip=1,2,3 contact=1,2,3 angle=0 flat",
        "3 programmed tip=0.96,2,3.04 shift=-0.04,0,0.04 contact=-2,2,6 angle=90"}},
      {"Deviations: below the", {"2 E_3DTC_RANGE"}},
      {"Deviations: above the", {"2 E_3DTC_RANGE"}},
      {"Deviations: three segments",
       {"2 W_NOT_NORMALIZED",
        "2 programmed tip=0.978056858214413,2,3.01581572175896 shift=-0.021943141785587,0,0.01581572175896 "
        "contact=-1.846049894151541,2,5.051316701949486 angle=71.565051177077989",
        "3 programmed tip=1.021213203435596,2,2.991213203435596 shift=0.021213203435596,0,-0.008786796564404 "
        "contact=-1.121320343559643,2,3.878679656440357 angle=45",
        "4 programmed tip=1,1.94,3.06 shift=0,-0.06,0.06 contact=1,-1,6 angle=90"}},
      {"Deviations: a single",
       {"2 programmed tip=1.1,2,2.9 shift=0.1,0,-0.1 contact=-2,2,6 angle=90", "3 E_3DTC_RANGE"}},
      {"Deviations: DR2 of TOOL CALL is",
       {"2 programmed tip=0.964,2,3.012 shift=-0.036,0,0.012 contact=-0.8,2,3.6 angle=36.869897645844021"}},
      {"Deviations: the sum of DR2 from", {"3 E_OVERSIZE_DR2"}},
      {"Deviations: DR 0.1", {"2 E_OVERSIZE_DR"}},
      {"Deviations: with DR -1",
       {"2 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6 angle=36.869897645844021"}},
      {"Deviations: R2 other", {"2 E_3DTC_SHAPE"}},
      {"Deviations: the corner",
       {"2 programmed tip=-1.121320343559643,2,3.878679656440357 shift=-2.121320343559643,0,0.878679656440357 "
        "contact=-1.121320343559643,2,3.878679656440357 angle=45"}},
      {"Deviations: at a", {"2 E_R2_NEG"}},
      {"Deviations: a negative", {"2 E_R2_NEG"}},
      {"Deviations apply", {"2 programmed tip=1,0,0", "3 W_NO_LATERAL", "3 programmed tip=2,0,0 axis=0,0.6,0.8"}},
      {"Without T the tool",
       {"2 programmed tip=1,2,3 axis=0.6,0,0.8 contact=1,2,3 flat", "3 programmed tip=5,2,3 axis=0.6,0,0.8",
        "4 programmed tip=5,2,5 axis=0.6,0,0.8", "5 programmed tip=5,2,6"}},
      {"T is ignored without", {"2 W_T_IGNORED", "2 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6"}},
      {"RL in a block with", {"2 E_RC_WITH_N"}},
      {"RR from a block before", {"2 start-up tip=5,0.1,0 shift=0,0.1,0", "3 E_RC_WITH_N"}},
      {"E_NO_TOOL comes before", {"1 E_NO_TOOL"}},
      {"Before E_TOOL comes", {"2 E_RC_WITH_N"}},
      {"Vectors off by exactly",
       {"3 programmed tip=0.89998999849975,2,3.098009801470245 shift=-0.10001000150025,0,0.098009801470245 "
        "axis=-0.010001000150025,0.14001400210035,0.990099014852475 contact=-2.000300045007501,2,5.940294044107351"}},
      {"A normal off by a little",
       {"2 W_NOT_NORMALIZED",
        "2 programmed tip=0.900856137022296,1.986981108901918,3.098998546838609 "
        "shift=-0.099143862977704,-0.013018891098082,0.098998546838609 "
        "contact=-1.97431588933113,1.609433267057528,5.969956405158271"}},
      {"Normal and tool vector",
       {"2 W_NOT_NORMALIZED", "2 W_NOT_NORMALIZED",
        "2 programmed tip=0.26,0,-0.02 shift=0.26,0,-0.02 tool=0.26,0,0.23 axes=0.26,0,0.23 contact=-4.2,0,0.4"}},
      {"A normal at right angles", {"2 programmed tip=0.9,2,3.02 shift=-0.1,0,0.02 contact=-4,2,5"}},
      {"A normal below by rounding",
       {"2 programmed tip=1,2,3 contact=-3.99999999,2,5.000199999999", "3 W_N_BELOW",
        "3 programmed tip=1,2,3 contact=-3.999999910000006,2,5.000599999973"}},
      {"A normal opposite to", {"2 W_N_BELOW", "2 programmed tip=1,2,3.2 shift=0,0,0.2 contact=1,2,9 flat"}},
      {"The contact moves",
       {"2 programmed tip=1,2,3 contact=-3.2,2,3.4", "3 programmed tip=1,2,3 contact=1,-2.2,3.4", "4 W_CONTACT_JUMP",
        "4 programmed tip=1,2,3 contact=1,6.2,3.4", "5 W_CONTACT_JUMP", "5 programmed tip=1,2,3 contact=1,2,3 flat",
        "6 programmed tip=1,2,3 contact=1,2,3 flat", "7 W_CONTACT_JUMP", "7 programmed tip=1,2,3 contact=1,6.2,3.4",
        "8 programmed tip=5,2,3", "9 programmed tip=1,2,3 contact=1,-2.2,3.4"}},
      {"TOOL CALL clears the",
       {"2 programmed tip=1,2,3 contact=-3.2,2,3.4", "4 programmed tip=1,2,3 contact=5.2,2,3.4", "7 W_CONTACT_JUMP",
        "7 programmed tip=1,2,3 contact=-3.2,2,3.4"}},
      {"LN without a normal",
       {"2 programmed tip=1,2,3 contact=-3.2,2,3.4", "3 W_NO_LATERAL", "3 programmed tip=1,2,3",
        "4 programmed tip=1,2,3 contact=5.2,2,3.4"}},
      {"A ball has no flat",
       {"2 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6",
        "3 programmed tip=1.06,2,3.02 shift=0.06,0,0.02 contact=2.8,2,3.6"}},
      {"A ball that has",
       {"2 programmed tip=1.04,2,3.02 shift=0.04,0,0.02 contact=-0.8,2,3.6", "3 W_CONTACT_JUMP",
        "3 programmed tip=0.96,2,3.02 shift=-0.04,0,0.02 contact=2.8,2,3.6"}},
      {"All warnings of a block without",
       {"2 programmed tip=1,2,3 contact=-3.2,2,3.4", "3 W_DIGITS", "3 W_T_IGNORED", "3 W_NOT_NORMALIZED", "3 W_N_BELOW",
        "3 W_CONTACT_JUMP", "3 programmed tip=1.123456,2,3 contact=5.323456,2,6.6"}},
      {"All warnings of a block under",
       {"2 programmed tip=1,2,3 contact=-3.2,2,3.4", "3 W_DIGITS", "3 W_NOT_NORMALIZED", "3 W_NOT_NORMALIZED",
        "3 W_N_BELOW", "3 W_CONTACT_JUMP", "3 programmed tip=1,2,123456 contact=5.2,2,123459.6"}},
      {"A block with an alarm", {"2 E_OVERSIZE_DR"}},
      {"An end mill: D_tip", {"2 programmed tip=0.9,2,3 shift=-0.1,0,0 contact=-4,2,3"}},
      {"The tool along X: t",
       {"2 programmed tip=1.04,2,3.02 shift=0.04,0,0.02 tool=0.54,0,0.02 axes=1.54,2,3.02 axis=1,0,0 "
        "contact=1.8,2,-1.6"}},
      {"The tool along Y, and",
       {"2 programmed tip=1,2.02,3.04 shift=0,0.02,0.04 tool=0,0.52,0.04 axes=1,2.52,3.04 axis=0,1,0 "
        "contact=1,2.4,-1.2",
        "4 programmed tip=1,2.04,3.02 shift=0,0.04,0.02 tool=0,0.04,0.52 axes=1,2.04,3.52 contact=1,-2.2,3.4"}},
  };
  space::expect(kSection, "rules", table);
}

TEST(FaceMillingVectors, Klartext) {
  const std::vector<worked::Example> table = {
      {"LN without Z: E_LN", {"2 programmed tip=1,0,0", "3 E_LN_COORD"}},
      {"LN with Y before X", {"2 programmed tip=1,0,0", "3 E_LN_ORDER"}},
      {"LN without NY: E_VEC", {"2 programmed tip=1,0,0", "3 E_VEC_INCOMPLETE"}},
      {"LN with TX alone: E", {"2 programmed tip=1,0,0", "3 E_VEC_INCOMPLETE"}},
      {"LN with T before N", {"2 programmed tip=1,0,0", "3 E_LN_ORDER"}},
      {"LN with NX twice: E", {"2 programmed tip=1,0,0", "3 E_LN_ORDER"}},
      {"LN with a normal of", {"2 programmed tip=1,0,0", "3 E_VEC_ZERO"}},
      {"LN with a tool vector", {"2 programmed tip=1,0,0", "3 E_VEC_ZERO"}},
      {"LN with NX+10: E_VEC", {"2 programmed tip=1,0,0", "3 E_VEC_RANGE"}},
      {"LN with NX 9.99999999",
       {"2 programmed tip=1,0,0", "3 W_NOT_NORMALIZED", "3 programmed tip=0.9,2,3.1 shift=-0.1,0,0.1 contact=-2,2,6",
        "4 programmed tip=2,2,3"}},
      {"LN with a normal under", {"2 programmed tip=1,0,0", "3 E_RC_WITH_N"}},
      {"Five M functions: E", {"2 programmed tip=1,0,0", "3 E_TOO_MANY_M"}},
      {"Four M functions are permitted.",
       {"2 programmed tip=1,0,0", "3 programmed tip=1,2,3 contact=1,2,3 flat", "4 programmed tip=2,2,3"}},
      {"Five M functions and", {"2 programmed tip=1,0,0", "3 E_TOO_MANY_M"}},
      {"A parameter in a tool", {"2 programmed tip=1,0,0", "3 E_SYNTAX"}},
      {"LN without any vector", {"2 programmed tip=1,0,0", "3 E_SYNTAX"}},
      {"LN with an incremental", {"2 programmed tip=1,0,0", "3 E_SYNTAX"}},
      {"LN with a rotary word", {"2 programmed tip=1,0,0", "3 E_SYNTAX"}},
      {"A word of another dialect", {"2 programmed tip=1,0,0", "3 E_SYNTAX"}},
      {"BEGIN PGM after the", {"2 programmed tip=1,0,0", "3 E_SYNTAX"}},
      {"An axis that the setup", {"2 programmed tip=1,0,0", "3 E_SYNTAX"}},
      {"TOOL CALL under TCPM", {"2 programmed tip=1,0,0", "4 E_TCPM_TOOLCALL"}},
      {"An unknown tool: E", {"2 programmed tip=1,0,0", "3 E_NO_TOOL"}},
      {"A tool called by", {"2 programmed tip=1,0,0", "3 E_NO_TOOL"}},
      {"Under TCPM an unknown", {"2 programmed tip=1,0,0", "4 E_TCPM_TOOLCALL"}},
      {"M91 under TCPM: E_TCPM", {"2 programmed tip=1,0,0", "3 E_TCPM_M91"}},
      {"M92 under TCPM with", {"2 programmed tip=1,0,0", "4 E_TCPM_M91"}},
      {"E_TCPM_M91 is raised", {"1 E_TCPM_M91"}},
      {"Decimal commas, minus",
       {"6 programmed tip=1.5,-2.5,-3", "7 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6"}},
      {"Blocks with / run if the", {"1 programmed tip=100,0,0", "2 programmed tip=200,0,0"}},
      {"Six decimals, a position",
       {"2 W_DIGITS", "2 programmed tip=1.123456,0,0", "3 W_DIGITS", "3 programmed tip=123456,0,0", "4 W_DIGITS",
        "4 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6",
        "5 programmed tip=1.12345,-99999.99999,3"}},
      {"M30 ends the program", {"2 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6"}},
      {"END PGM ends the program", {"3 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6"}},
      {"Without BEGIN PGM the",
       {"2 programmed tip=0.9,2,3 shift=-0.1,0,0 tool=-0.1,0,0.1 axes=0.9,2,3.1 contact=-9,2,3 feed=10"}},
      {"Parameters: Q1 = -6",
       {"6 programmed tip=-6,6,0", "7 programmed tip=2.5,-2.5,0 feed=0", "8 programmed tip=2.5,-2.5,6 feed=0"}},
      {"A parameter as DR in", {"3 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6"}},
      {"Feeds: that of TOOL",
       {"1 programmed tip=1,0,0", "3 programmed tip=2,0,0 feed=500", "4 programmed tip=3,0,0 feed=200",
        "5 rapid programmed tip=4,0,0", "6 programmed tip=5,0,0 feed=200", "7 programmed tip=6,0,0 feed=500",
        "8 programmed tip=7,0,0", "9 programmed tip=8,0,0", "10 programmed tip=9,0,0 feed=500",
        "11 programmed tip=10,0,0", "12 rapid programmed tip=11,0,0", "13 programmed tip=12,0,0 feed=300"}},
      {"Incremental words are",
       {"2 programmed tip=105,2,7", "3 programmed tip=102.5,3,7",
        "4 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6", "5 programmed tip=2,2,4"}},
      {"Cycle 7 shifts the",
       {"2 programmed tip=10,10,0", "6 programmed tip=101,10,0", "7 programmed tip=101,11,0",
        "9 programmed tip=112,11,0", "10 programmed tip=111.94,-3,3.02 shift=-0.06,0,0.02 contact=110.2,-3,3.6"}},
      {"M91 and M92: the datum",
       {"4 programmed tip=101,0,21", "5 programmed tip=1,0,21", "6 programmed tip=1,1,21", "7 programmed tip=1,1,2",
        "8 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6",
        "9 programmed tip=100.94,2,23.02 shift=-0.06,0,0.02 contact=99.2,2,23.6"}},
      {"Other cycles, PLANE", {"14 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6"}},
      {"Tools called by number",
       {"2 programmed tip=1,2,3 contact=-0.2,2,3.4",
        "4 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6",
        "6 programmed tip=1,2,3 tool=0,0,1 axes=1,2,4 contact=-0.2,2,3.4"}},
      {"Deltas of a call with",
       {"2 programmed tip=0.88,2,3.04 shift=-0.12,0,0.04 tool=-0.12,0,1.04 axes=0.88,2,4.04 contact=-0.8,2,3.6",
        "4 programmed tip=0.88,2,3.04 shift=-0.12,0,0.04 tool=-0.12,0,2.04 axes=0.88,2,5.04 contact=-0.8,2,3.6",
        "6 programmed tip=1,2,3 contact=-0.8,2,3.6"}},
      {"A row of the compensation",
       {"3 programmed tip=0.88,2,3.04 shift=-0.12,0,0.04 tool=-0.12,0,1.04 axes=0.88,2,4.04 contact=-0.8,2,3.6",
        "5 programmed tip=0.88,2,3.04 shift=-0.12,0,0.04 tool=-0.12,0,1.04 axes=0.88,2,4.04 contact=-0.8,2,3.6",
        "7 programmed tip=1,2,3 contact=-0.8,2,3.6"}},
      {"FUNCTION CORRDATA RESET",
       {"5 programmed tip=0.88,2,3.04 shift=-0.12,0,0.04 tool=-0.12,0,1.04 axes=0.88,2,4.04 contact=-0.8,2,3.6",
        "7 programmed tip=0.88,2,3.04 shift=-0.12,0,0.04 tool=-0.12,0,1.04 axes=0.88,2,4.04 contact=-0.8,2,3.6",
        "9 programmed tip=1,2,3 contact=-0.8,2,3.6", "12 programmed tip=1,2,3 contact=-0.8,2,3.6"}},
      {"TOOL CALL 0 cancels",
       {"2 programmed tip=1,0,0 tool=0,0,0.5 axes=1,0,0.5", "4 programmed tip=2,0,0 tool=0,0,1.5 axes=2,0,1.5",
        "6 programmed tip=3,0,0"}},
      {"M128 takes effect",
       {"2 W_T_IGNORED", "2 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6",
        "3 programmed tip=0.94,2.06,3 shift=-0.06,0.06,0 axis=0,0.6,0.8 contact=-0.8,3.8,3",
        "4 programmed tip=5,2,3 axis=0,0.6,0.8",
        "5 programmed tip=0.94,2.06,3 shift=-0.06,0.06,0 axis=0,0.6,0.8 contact=-0.8,3.8,3", "6 programmed tip=6,2,3"}},
      {"FUNCTION TCPM switches",
       {"3 programmed tip=1,2,3 axis=0.6,0,0.8 contact=1,2,3 flat", "5 programmed tip=5,2,3",
        "7 programmed tip=-0.8,2,0.6 axis=0.6,0,0.8 contact=-0.8,2,0.6 flat", "9 programmed tip=6,2,3"}},
      {"Under CNT-CNT the programmed",
       {"3 programmed tip=2,0,0 axis=1,0,0 carrier=52,0,0 B=90", "4 programmed tip=3,0,0 axis=1,0,0 carrier=53,0,0"}},
      {"M128 sets the reference",
       {"3 programmed tip=5,0,-3", "4 programmed tip=6,0,0", "6 programmed tip=7,0,-3", "8 programmed tip=8,0,0",
        "10 programmed tip=9,0,-3", "12 programmed tip=10,0,0", "14 programmed tip=11,0,0"}},
      {"CNT-CNT is lost when", {"3 programmed tip=5,0,-3", "5 programmed tip=6,0,0", "6 programmed tip=7,0,0"}},
      {"Rotary words turn the",
       {"3 programmed tip=0,0,0 axis=0,-1,0 A=90", "4 programmed tip=0,0,0 axis=0,-1,0 B=90",
        "5 programmed tip=0,0,0 axis=0,1,0 C=180", "6 programmed tip=0,0,0 axis=-1,0,0 A=0"}},
      {"Rotary words without",
       {"2 programmed tip=0,0,0 B=60", "3 programmed tip=0,0,0 B=90", "4 programmed tip=1,0,0 axis=1,0,0",
        "5 programmed tip=2,0,0 axis=0,1,0 C=90", "6 programmed tip=0.94,2,3.02 shift=-0.06,0,0.02 contact=-0.8,2,3.6",
        "7 programmed tip=3,2,3", "8 programmed tip=4,2,3 axis=-1,0,0 C=180"}},
      {"With the tool axis",
       {"2 programmed tip=0,0,0 tool=0,0,1 axes=0,0,1 A=90", "3 programmed tip=0,0,0 tool=0,0,1 axes=0,0,1 C=90"}},
      {"A call without a tool",
       {"2 programmed tip=1,0,0", "4 programmed tip=2,0,0", "5 programmed tip=2,0,0 axis=0,1,0 C=90"}},
  };
  space::expect(kSection, "klartext", table);
}

// E1 and E11 to 30 digits, typed in like the others.
TEST(FaceMillingVectors, ThirtyDigits) {
  constexpr int kThirty = 30;
  const auto vector = [](const std::array<model::Real, 3>& v) {
    return space::Rows{v[0].decimal(kThirty), v[1].decimal(kThirty), v[2].decimal(kThirty)};
  };
  const judge::ModelRun reworked = judge::run_model(worked::vector_of(kSection, "examples", "E1: "));
  const model::Event& e1 = reworked.events.back();
  EXPECT_EQ(vector({e1.point[0], e1.point[1], e1.point[2]}),
            (space::Rows{"36.054981069776460940259370772112", "6.24258845869536030452846923275",
                         "-1.933902321076867630085102893279"}));
  const judge::ModelRun toroid = judge::run_model(worked::vector_of(kSection, "examples", "E11: "));
  ASSERT_TRUE(toroid.events.back().space);
  EXPECT_EQ(vector(toroid.events.back().space->tool_shift),
            (space::Rows{"0.059390409959017042630107200988", "0.093008090294541035995889864545",
                         "-0.005778374413737617893829685651"}));
}

// E16 is rational: the fractions by hand.
TEST(FaceMillingVectors, Fractions) {
  const spec::TextEvent& e16 = worked::vector_of(kSection, "examples", "E16: ").expect.back();
  ASSERT_TRUE(e16.space);
  EXPECT_EQ(e16.space->shift[0].q, "13/50");
  EXPECT_EQ(e16.space->shift[2].q, "-1/50");
  EXPECT_EQ(e16.space->tool_shift[2].q, "23/100");
  EXPECT_EQ(e16.space->tool_center[2].q, "52/25");
  ASSERT_TRUE(e16.space->contact);
  EXPECT_EQ(e16.space->contact->point[0].q, "-21/5");
  EXPECT_EQ(e16.space->contact->point[2].q, "2/5");
}

}  // namespace
}  // namespace toolcomp::corpus
