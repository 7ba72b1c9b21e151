// Sequences: pictures that are numbered, whose changes are held to the reference's from both sides.
#include "tests/program/screenshots/folders.h"

namespace {

using tests::expectSays;

class Sequences : public tests::Folders {
  protected:
    static std::string frame(int i) { return "a_000" + std::to_string(i) + ".png"; }

    /// A square that moves by a pixel each frame.
    Sequences() {
        for (int i = 0; i < 5; ++i) writeBoth(frame(i), square(4 + static_cast<uint32_t>(i)));
    }

    /// Limits of single pictures out of the way, as where waves are never the same.
    tests::Outcome compareChanges(const std::string& flicker) const {
        return compare({"--max-flip", "1", "--max-flicker", flicker});
    }
};

TEST_F(Sequences, ThatMoveAsTheReferenceAreTheSame) {
    expectSays(compare({"--tolerant"}), 0, {"same: a_*.png"});
    // Another place, the same changes.
    for (int i = 0; i < 5; ++i) write("out/" + frame(i), square(14 + static_cast<uint32_t>(i)));
    expectSays(compareChanges("0.1"), 0, {"same: a_*.png"});
}

TEST_F(Sequences, APoppedFrameChangesTooMuch) {
    write("out/" + frame(2), square(26));
    expectSays(compareChanges("0.2"), 1, {"a_*.png: the change to a_0002.png: ", "of FLIP is "});
    expectSays(compare({"--max-flip", "1"}), 0, {"same: a_0002.png"});
}

TEST_F(Sequences, AFrozenOneChangesTooLittle) {
    for (int i = 1; i < 5; ++i) write("out/" + frame(i), square(4));
    expectSays(compareChanges("0.2"), 1, {"the change to a_0001.png: ", "of FLIP is 0, expected 0."});
}

TEST_F(Sequences, EndAtAGapAndNeedTwo) {
    std::filesystem::remove(at("out/" + frame(1)));
    write("out/" + frame(3), square(26));
    const tests::Outcome outcome = compareChanges("0.2");
    expectSays(outcome, 1, {"a_0001.png: no picture"});
    EXPECT_EQ(outcome.out.find("a_*.png"), std::string::npos) << outcome.out;
}

TEST_F(Sequences, NumbersOfOneDigitAreNames) {
    writeBoth("level1.png", square(4));
    writeBoth("level2.png", square(4));
    write("out/level2.png", square(20));
    EXPECT_EQ(compareChanges("0.2").out.find("level*"), std::string::npos);
}

TEST_F(Sequences, ABrokenFrameEndsNothingElse) {
    tests::writeAll(at("out/" + frame(4)), "no picture");
    write("out/" + frame(2), square(26));
    expectSays(compareChanges("0.2"), 2, {"not compared: a_0004.png", "a_*.png: the change to a_0002.png"});
}

} // namespace
