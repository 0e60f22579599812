#include "jobs/store.hpp"

#include <gmock/gmock.h>

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool::jobs {
namespace {

using ddtool::test::TemporaryFolder;
using testing::HasSubstr;

class StoreTest : public ::testing::Test {
protected:
    /// The number that is stored under the key, or -1 if there is none.
    [[nodiscard]] int found(const Key& key) const {
        return store_.find(key, [](const Json& json) { return json.get<int>(); }).value_or(-1);
    }
    /// What looking up the key writes on stderr.
    [[nodiscard]] std::string said_for(const Key& key) const {
        testing::internal::CaptureStderr();
        EXPECT_EQ(found(key), -1);
        return testing::internal::GetCapturedStderr();
    }

    TemporaryFolder folder_;
    Store store_{folder_ / ".", {.value_key = "answer"}};
    Key key_{Json{{"question", "six times nine"}, {"base", 13}}};
};

TEST(Key, IsOfTheConfigurationAloneAndAlwaysTheSame) {
    EXPECT_EQ(Key(Json{{"a", 1}}).id(), Key(Json{{"a", 1}}).id());
    EXPECT_NE(Key(Json{{"a", 1}}).id(), Key(Json{{"a", 2}}).id());
    EXPECT_EQ(Key(Json{{"a", 1}}).id(), "9c3e82dd6fcae8b1") << "folders of earlier versions are found by it";
}

TEST_F(StoreTest, GivesBackWhatWasSaved) {
    EXPECT_EQ(found(key_), -1);
    store_.save(key_, 42);
    EXPECT_EQ(found(key_), 42);
    EXPECT_EQ(found(Key(Json{{"question", "six times nine"}, {"base", 10}})), -1);
    store_.save(key_, 54);
    EXPECT_EQ(found(key_), 54);
}

TEST_F(StoreTest, AnEntryHoldsItsConfiguration) {
    store_.save(key_, 42);
    const Json entry = Json::parse(read_file(store_.file(key_, ".json")));
    EXPECT_EQ(entry, (Json{{"configuration", key_.configuration()}, {"answer", 42}}));
}

TEST_F(StoreTest, LooksIntoAFolderThatIsNotThere) {
    const Store nowhere(folder_ / "nowhere", {.value_key = "answer"});
    EXPECT_FALSE(nowhere.find(key_, [](const Json& json) { return json; }));
}

TEST_F(StoreTest, NamesADamagedEntryAndTakesItForNone) {
    store_.save(key_, 42);
    const auto file = store_.file(key_, ".json");
    const std::string whole = read_file(file);
    const Key other(Json{{"question", "another"}});
    store_.save(other, 7);
    for (const std::string& damaged :
         {std::string(), whole.substr(0, whole.size() / 2), std::string("[]"), read_file(store_.file(other, ".json")),
          Json{{"configuration", key_.configuration()}}.dump(),
          Json{{"configuration", key_.configuration()}, {"answer", "text"}}.dump()}) {
        write_file(file, damaged);
        EXPECT_THAT(said_for(key_), HasSubstr(file.string() + ": damaged, so it counts as missing: ")) << damaged;
    }
    store_.save(key_, 42);
    EXPECT_EQ(found(key_), 42);
}

TEST_F(StoreTest, TakesAnEntryForNoneWhenWhatLiesBesideIsDamaged) {
    store_.save(key_, 42);
    testing::internal::CaptureStderr();
    const auto found = store_.find(key_, [&](const Json&) -> int { throw Error("beside.npy: cut off"); });
    EXPECT_FALSE(found);
    EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("beside.npy: cut off"));
}

}  // namespace
}  // namespace ddtool::jobs
