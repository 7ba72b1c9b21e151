// seaglass sea: the figures it prints are those of the surface, and bad lines are refused.
#include <gtest/gtest.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "program/program.h"
#include "tests/program/refused.h"

namespace {

using nlohmann::json;
using tests::Outcome;

class SeaCommand : public testing::Test {
  protected:
    Outcome sea(const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"sea"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return tests::run(demos::runProgram, {arguments, {}, folder_.path()});
    }
    json figures(std::vector<std::string> more, const char* samples = "128") {
        more.insert(more.end(), {"--json", "--samples", samples});
        const Outcome outcome = sea(more);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return json::parse(outcome.out, nullptr, false);
    }
    void expectRefused(const std::vector<std::string>& more, const std::vector<std::string>& words) {
        tests::expectRefused(sea(more), words);
        EXPECT_TRUE(tests::namesIn(folder_.path()).empty());
    }

    const tests::TemporaryFolder folder_;
};

TEST_F(SeaCommand, PrintsThePublishedHeights) {
    const json pm = figures({"--wind", "10", "--spectrum", "pierson-moskowitz"});
    EXPECT_EQ(pm["spectrum"], "pierson-moskowitz");
    EXPECT_EQ(pm["wind_m_s"], 10);
    EXPECT_TRUE(pm["depth_m"].is_null());
    EXPECT_NEAR(pm["hs_spectrum_m"].get<double>(), 2.245, 0.01);
    EXPECT_NEAR(pm["hs_published_m"].get<double>(), 2.245, 0.01);
    EXPECT_NEAR(pm["hs_resolved_m"].get<double>(), 2.245, 0.03);
    EXPECT_NEAR(pm["hs_simulated_m"].get<double>() / pm["hs_resolved_m"].get<double>(), 1, 0.02);
    EXPECT_NEAR(pm["tp_s"].get<double>(), 7.493, 0.01);
    EXPECT_NEAR(pm["tz_s"].get<double>(), 0.710 * 7.493, 0.02);
    const json tma =
        figures({"--wind", "15", "--fetch", "300e3", "--uncapped", "--spectrum", "tma", "--depth", "10"});
    EXPECT_EQ(tma["depth_m"], 10);
    EXPECT_NEAR(tma["hs_simulated_m"].get<double>() / 2.97, 1, 0.03);
    EXPECT_NEAR(tma["hs_published_m"].get<double>(), 2.97, 0.01);
    const json jonswap = figures({"--wind", "15", "--fetch", "300e3", "--uncapped"});
    EXPECT_NEAR(jonswap["hs_published_m"].get<double>(), 5.647, 0.01);
    EXPECT_TRUE(figures({"--wind", "15", "--spectrum", "phillips"})["hs_published_m"].is_null());
}

TEST_F(SeaCommand, WarnsOfWavesThatItsCascadesCannotHold) {
    const std::vector<std::string> line = {"--wind", "15", "--samples", "64", "--json"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), line.begin(), line.end());
        return sea(more);
    };
    const Outcome lost = with({"--patch", "60"});
    EXPECT_EQ(lost.code, 0);
    EXPECT_NE(lost.err.find("warning: the cascades hold"), std::string::npos) << lost.err;
    const json figures = json::parse(lost.out);
    EXPECT_LT(figures["resolved_share"].get<double>(), 0.5);
    EXPECT_NEAR(figures["hs_simulated_m"].get<double>() / figures["hs_resolved_m"].get<double>(), 1, 0.1);
    EXPECT_EQ(with({"--patch", "1500"}).err, "");
}

TEST_F(SeaCommand, AddsUp) {
    const json found = figures({"--wind", "8", "--swell", "0.4", "--spreading", "donelan-banner"});
    double variance = 0;
    ASSERT_EQ(found["cascades"].size(), 4u);
    double last = 0;
    for (const json& cascade : found["cascades"]) {
        variance += cascade["variance_m2"].get<double>();
        EXPECT_EQ(cascade["k_min"].get<double>(), last);
        last = cascade["k_max"].get<double>();
        EXPECT_GT(cascade["patch_m"].get<double>(), 0);
        EXPECT_EQ(cascade["samples"], 128);
    }
    EXPECT_NEAR(4 * std::sqrt(variance) / found["hs_simulated_m"].get<double>(), 1, 0.01);
    const json& slopes = found["slope_variance"];
    EXPECT_DOUBLE_EQ(slopes["resolved"].get<double>() + slopes["roughness"].get<double>(),
                     slopes["total"].get<double>());
    EXPECT_GT(slopes["resolved"].get<double>(), 0);
    EXPECT_NEAR(slopes["cox_munk"].get<double>(), 0.003 + 5.12e-3 * 8, 1e-9);
    for (const char* const law : {"simulated", "monahan", "callaghan"})
        EXPECT_GE(found["whitecap"][law].get<double>(), 0) << law;
    EXPECT_NEAR(found["whitecap"]["monahan"].get<double>(), 3.84e-6 * std::pow(8, 3.41), 1e-6);
}

TEST_F(SeaCommand, KnowsBeaufort) {
    const json found = figures({"--beaufort", "8"});
    EXPECT_NEAR(found["wind_m_s"].get<double>(), 18.9, 1e-5);
    EXPECT_NEAR(found["hs_simulated_m"].get<double>() / 5.5, 1, 0.05);
    EXPECT_EQ(found["hs_published_m"], 5.5);
}

TEST_F(SeaCommand, IsTheSameEachTime) {
    const std::vector<std::string> line = {"--wind", "6", "--samples", "64", "--json"};
    const Outcome once = sea(line);
    EXPECT_EQ(once.out, sea(line).out);
    std::vector<std::string> other = line;
    other.insert(other.end(), {"--seed", "99"});
    EXPECT_NE(once.out, sea(other).out);
}

TEST_F(SeaCommand, CalmIsFlat) {
    const json found = figures({"--wind", "0"});
    EXPECT_EQ(found["hs_simulated_m"], 0);
    EXPECT_TRUE(found["tp_s"].is_null());
    EXPECT_TRUE(found["cascades"].empty());
    expectRefused({"--wind", "0", "-o", "plot.svg"}, {"plot.svg", "flat sea"});
}

TEST_F(SeaCommand, ReadsATable) {
    tests::writeAll(folder_.path() / "buoy.csv", "# Hz, m^2/Hz\n0.05,0\n0.1, 4\n0.2,1\n0.4,0\n");
    const json found = figures({"--wind", "10", "--spectrum", "table", "--table", "buoy.csv"});
    EXPECT_NEAR(found["hs_simulated_m"].get<double>() / (4 * std::sqrt(0.45)), 1, 0.02);
    EXPECT_NEAR(found["hs_published_m"].get<double>(), 4 * std::sqrt(0.45), 1e-6);
    EXPECT_NEAR(found["tp_s"].get<double>(), 10, 1e-4);
    tests::writeAll(folder_.path() / "buoy.csv", "0.05,0\n0.1;4\n");
    const Outcome refused = sea({"--wind", "10", "--spectrum", "table", "--table", "buoy.csv"});
    tests::expectRefused(refused, {"buoy.csv:2: '0.1;4'", "expected two numbers"});
    tests::writeAll(folder_.path() / "buoy.csv", "0.2,0\n0.1,4\n");
    tests::expectRefused(sea({"--wind", "10", "--spectrum", "table", "--table", "buoy.csv"}),
                         {"buoy.csv:2: frequency is 0.1, expected more than in the line before"});
}

TEST_F(SeaCommand, TablesAreReadAsOtherProgramsWriteThem) {
    const auto found = [&](const std::string& text) {
        tests::writeAll(folder_.path() / "buoy.csv", text);
        return figures({"--wind", "10", "--spectrum", "table", "--table", "buoy.csv"}, "32");
    };
    const json plain = found("0.05,0\n0.1,4\n0.2,1\n0.4,0\n");
    for (const std::string text :
         {"\xEF\xBB\xBF"
          "0.05,0\n0.1,4\n0.2,1\n0.4,0\n",
          "frequency_Hz,S_m2_per_Hz\n0.05,0\n0.1,4\n0.2,1\n0.4,0", "0.05,1e-63\n0.1,4\n0.2,1\n0.4,1e-4000\n",
          "# a\n\n0.05,0\r\n0.1,4\r\n0.2,1\r\n0.4,0\r\n", "0.05,0\r0.1,4\r0.2,1\r0.4,0\r",
          "f (Hz),S (m^2/Hz)\n0.05,0\n0.1,4\n0.2,1\n0.4,0\n",
          "# f [1/s],\"S(f) [m\xC2\xB2 s]\"\n0.05,0\n0.1,4\n0.2,1\n0.4,0\n",
          "Frequency,Density (m2 Hz-1)\n# by a buoy (old), no rad/s (sic) "
          "here\n0.05,0\n0.1,4\n0.2,1\n0.4,0\n",
          "\"Hz\",\"S\"\n\"0.05\",\"0\"\n\"0.1\",\"+4\"\n0.2,1\n0.4,1e-40\n"})
        EXPECT_EQ(found(text), plain) << text;
}

TEST_F(SeaCommand, TablesOfSomethingElseAreNamed) {
    const auto expect = [&](const std::string& text, const std::vector<std::string>& words) {
        tests::writeAll(folder_.path() / "buoy.csv", text);
        tests::expectRefused(sea({"--wind", "10", "--spectrum", "table", "--table", "buoy.csv"}), words);
    };
    expect("0.05,0\n0.1,999\n0.2,1\n", {"buoy.csv:2: density is 999", "missing"});
    expect("0.05,0\n0.1,999.00\n0.2,1\n", {"buoy.csv:2: density is 999.00", "missing"});
    for (const std::string missing : {"9999", "99999", "-999", "999.9", "999.99", "9.990e+02"})
        expect("0.05,0\n0.1," + missing + "\n0.2,1\n", {"density is " + missing, "missing"});
    expect("0.05,0\n0.1,MM\n0.2,1\n", {"buoy.csv:2: density is MM", "missing"});
    expect("0.05;0\n0.1;4\n", {"buoy.csv:1: '0.05;0' has a semicolon"});
    expect("0,05;0\n0,1;4\n", {"buoy.csv:1: '0,05;0' has a semicolon"});
    expect("0.05\t0\n0.1\t4\n", {"buoy.csv:1:", "has a tab"});
    expect("0,05,0,1\n", {"buoy.csv:1: '0,05,0,1' has more than one comma", "decimal points"});
    for (const std::string heading : {"omega (rad/s),S", "f [mHz],S", "f (kHz),S", "Period,S", "T (s),S",
                                      "f (1/rad),S", "f,S (cm^2/Hz)", "f,S (m^2 s/rad)", "f,S (J/m^2/Hz)",
                                      "f,S [m]", "f,S_m2_per_mHz", "f,S (dB)", "f (Hz),S (m^2/Hz/deg)"})
        expect(heading + "\n0.1,1\n0.2,4\n", {"buoy.csv:1: its heading says '", "expected Hz and m^2/Hz"});
    expect("# w (rad/s),S (m^2s)\n0.1,1\n0.2,4\n", {"its heading says '# w (rad/s)'"});
    expect("Hz,S\nHz,S\n0.1,4\n", {"buoy.csv:2: 'Hz,S', expected two numbers"});
    expect("0.05,1e400\n0.1,4\n", {"buoy.csv:1: '0.05,1e400'"});
    expect("0.05,nan\n0.1,4\n", {"buoy.csv:1: density is nan, expected 0 to 1e+06 m^2/Hz"});
    expect("0.05,0\n0.1,-4\n", {"buoy.csv:2: density is -4, expected 0 to 1e+06 m^2/Hz"});
    // What netCDF and Fortran programs write for a missing one.
    expect("0.05,0\n0.1,9.96921e+36\n", {"buoy.csv:2: density is 9.96921e+36, expected 0 to 1e+06"});
    expect("0,0\n0.1,4\n", {"buoy.csv:1: frequency is 0, expected 0.01 to 50 Hz"});
    expect("0.1,4\n", {"buoy.csv: one sample alone"});
    expect("0.1,0\n0.1,4\n", {"buoy.csv:2: frequency is 0.1, expected more than in the line before"});
    expect("", {"buoy.csv: no spectrum"});
    expect(std::string("0.05,0\n\0\0", 9), {"buoy.csv:2: a zero byte"});
    expect("\xFF\xFE"
           "0",
           {"buoy.csv: is UTF-16"});
    expect(std::string((size_t(1) << 20) + 1, '\0'), {"buoy.csv: is over 1 MiB"});
}

TEST_F(SeaCommand, PlotsTheSpectrum) {
    const Outcome outcome = sea({"--wind", "10", "--samples", "64", "-o", "sea.svg"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("significant height"), std::string::npos);
    EXPECT_EQ(tests::namesIn(folder_.path()), (std::vector<std::string>{"sea.gp", "sea.svg"}));
    EXPECT_NE(tests::readAll(folder_.path() / "sea.svg").find("simulated"), std::string::npos);
}

TEST_F(SeaCommand, BadLinesAreRefused) {
    expectRefused({}, {"no wind", "--wind U"});
    expectRefused({"--wind", "-1"}, {"--wind is '-1'", "0 to 100 m/s"});
    expectRefused({"--wind", "nan"}, {"--wind is 'nan'", "0 to 100 m/s"});
    expectRefused({"--wind", "5", "--fetch", "0"}, {"--fetch is '0'", "1 to 1e+06 m"});
    expectRefused({"--wind", "5", "--depth", "-2"}, {"--depth is '-2'", "0 to inf m"});
    expectRefused({"--wind", "5", "--spectrum", "jonswop"},
                  {"--spectrum is 'jonswop', expected ", " tma, phillips", "; the nearest is jonswap"});
    expectRefused({"--wind", "5", "--spreading", "cos"}, {"--spreading is 'cos'", "nearest is cos2s"});
    expectRefused({"--wind", "5", "--swell", "2"}, {"--swell is '2'", "0 to 1"});
    expectRefused({"--wind", "5", "--samples", "100"}, {"--samples is '100'", "power of two"});
    expectRefused({"--wind", "5", "--cascades", "5"}, {"--cascades is '5'", "1 to 4"});
    expectRefused({"--wind", "5", "--patch", "0.5"}, {"--patch is '0.5'", "0 or 1 to 1e+05 m"});
    expectRefused({"--wind", "5", "-o", "sea.png"}, {"sea.png", "expected .svg"});
    expectRefused({"--wind", "5", "--tabl", "x"}, {"--tabl", "nearest is --table"});
    expectRefused({"--wind", "5", "--spectrum", "table"}, {"--spectrum is table", "--table FILE.csv"});
    expectRefused({"--wind", "5", "--seed", "-1"}, {"--seed is '-1'", "0 to 2^63"});
    for (const char* const force : {"13", "4.5"})
        expectRefused({"--beaufort", force}, {force, "expected a whole number, 0 to 12"});
    expectRefused({"--beaufort", "3", "--wind", "4"}, {"--wind is given with --beaufort"});
}

} // namespace
