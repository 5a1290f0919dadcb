#include "commands/at_most.h"

#include <gmock/gmock.h>

namespace lapfx::commands {
namespace {

using testing::ElementsAre;

std::vector<std::string> texts_of(const std::vector<Fault>& faults) {
    std::vector<std::string> texts;
    for (const Fault& fault : faults) texts.push_back(fault.text());
    return texts;
}

std::vector<std::string> refused(const std::vector<std::string>& texts) {
    try {
        (void)limits_of(texts);
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        return texts_of(error.faults());
    }
    return {"taken"};
}

/// What is said of one figure of the veil.
std::vector<std::string> said(const std::string& text, const match::AmountLikeness& veil) {
    const std::vector<std::string> texts{text};
    return texts_of(
        faults_of(limits_of(texts), {.amounts = {.overlap = 1.0, .blood = {}, .veil = veil}, .colors = {}}));
}

match::AmountLikeness with(std::optional<double> match::AmountLikeness::*figure, double value) {
    match::AmountLikeness veil;
    veil.*figure = value;
    return veil;
}

TEST(AtMost, HoldsUpToTheLimit) {
    EXPECT_THAT(said("veil_rms=0.05", with(&match::AmountLikeness::rms, 0.05)), ElementsAre());
    EXPECT_THAT(said("veil_rms=0", with(&match::AmountLikeness::rms, 0.0)), ElementsAre());
    EXPECT_THAT(said("veil_rms=0.05", with(&match::AmountLikeness::rms, 0.12)),
                ElementsAre("veil_rms is 0.12, above the 0.05 that is allowed"));
    EXPECT_THAT(said("veil_rms=5e-2", with(&match::AmountLikeness::rms, 0.0500001)),
                ElementsAre("veil_rms is 0.0500001, above the 0.05 that is allowed"))
        << "they do not look alike";
}

TEST(AtMost, EarlyIsAsFarAsLateAndThinAsDense) {
    EXPECT_THAT(said("veil_late=0.5", with(&match::AmountLikeness::late, -0.4)), ElementsAre());
    EXPECT_THAT(said("veil_late=0.5", with(&match::AmountLikeness::late, -1.5)),
                ElementsAre("veil_late is -1.5, which counts as 1.5, above the 0.5 that is allowed"));
    EXPECT_THAT(said("veil_peak_ratio=1.5", with(&match::AmountLikeness::peak_ratio, 0.8)), ElementsAre());
    EXPECT_THAT(said("veil_peak_ratio=1.5", with(&match::AmountLikeness::peak_ratio, 0.5)),
                ElementsAre("veil_peak_ratio is 0.5, which counts as 2, above the 1.5 that is allowed"));
}

TEST(AtMost, WhatIsNotKnownDoesNotHold) {
    EXPECT_THAT(said("veil_late=0.5", {}),
                ElementsAre("veil_late is not known, so that it cannot be shown to be at most 0.5"));
}

TEST(AtMost, TellsEachThatDoesNotHold) {
    const std::vector<std::string> texts{"smoke_delta_e=5", "blood_rms=0.1", "tissue_delta_e=3"};
    match::Compared compared;
    compared.amounts.blood.rms = 0.01;
    compared.colors = {.blood = {}, .smoke = 6.0, .tissue = 4.0};
    EXPECT_THAT(texts_of(faults_of(limits_of(texts), compared)),
                ElementsAre("smoke_delta_e is 6, above the 5 that is allowed",
                            "tissue_delta_e is 4, above the 3 that is allowed"));
}

TEST(AtMost, RefusesWhatIsNoLimit) {
    EXPECT_THAT(refused({"veil_peak_ratio=0.5"}),
                ElementsAre("--at-most: veil_peak_ratio=0.5 never holds: of a ratio the larger of it and 1 / it is "
                            "limited, which is 1 at least"));
    EXPECT_THAT(refused({"veil_rsm=1"}),
                ElementsAre("--at-most: \"veil_rsm\" is not a figure; nearest is veil_rms (see lapfx help)"));
    EXPECT_THAT(refused({"veil_rms"}), ElementsAre("--at-most: \"veil_rms\" is not NAME=VALUE, such as veil_rms=0.05"));
    for (const std::string number : {"", "abc", "nan", "inf", "1e999", "1 ", "0.1x", "0,1"})
        EXPECT_THAT(refused({"veil_rms=" + number}),
                    ElementsAre("--at-most: veil_rms: \"" + number + "\" is not a number"));
    EXPECT_THAT(refused({"veil_rms=-0.1"}), ElementsAre("--at-most: veil_rms: -0.1 is below the minimum 0"));
    EXPECT_THAT(refused({"veil_rms=1", "veil_rms=2"}), ElementsAre("--at-most: veil_rms is given twice"));
    EXPECT_EQ(refused({"x=1", "veil_rms=-1", "veil_late=1"}).size(), 2U) << "every fault is told";
}

}  // namespace
}  // namespace lapfx::commands
