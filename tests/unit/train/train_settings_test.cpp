#include "train/train_settings.hpp"

#include <gmock/gmock.h>

#include "thrown_text.hpp"

namespace ddtool::train {
namespace {

using ddtool::test::thrown_text;
using testing::HasSubstr;

/// The default settings with one value changed. The keys of the path are separated by slashes.
TrainSettings with(const std::string& path, const Json& value) {
    Json json = TrainSettings();
    json[Json::json_pointer("/" + path)] = value;
    return json.get<TrainSettings>();
}

TEST(TrainSettings, SurviveTheWayThroughJson) {
    TrainSettings settings = with("image/size_px", 64);
    settings.augmentation.flip = false;
    settings.optimizer.name = "rmsprop";
    settings.seed = 99;
    const Json json = settings;
    EXPECT_EQ(Json(json.get<TrainSettings>()), json);
}

TEST(TrainSettings, AreValidByDefaultAndAtTheLimits) {
    expect_valid(TrainSettings());
    expect_valid(with("patience_epochs", 0));
    expect_valid(with("optimizer/warm_up_share", 1.0));
    expect_valid(with("optimizer/weight_decay", 0.0));
}

TEST(TrainSettings, NameTheOneThatMakesNoSense) {
    const std::vector<std::pair<const char*, Json>> senseless{{"label", "height"},
                                                              {"split", "random"},
                                                              {"loss", "mse"},
                                                              {"precision", "fp16"},
                                                              {"epochs", 0},
                                                              {"batch_size", 0},
                                                              {"image/size_px", 0},
                                                              {"augmentation/least_particles", 0},
                                                              {"optimizer/name", "sgd"},
                                                              {"optimizer/learning_rate", 0.0},
                                                              {"optimizer/weight_decay", -0.1},
                                                              {"optimizer/warm_up_share", 1.1},
                                                              {"optimizer/final_rate_share", -1.0},
                                                              {"optimizer/largest_gradient_norm", 0.0}};
    for (const auto& [path, value] : senseless) {
        const std::string key = std::string(path).substr(std::string(path).find('/') + 1);
        EXPECT_THAT(thrown_text<UsageError>([&, path = path, value = value] { expect_valid(with(path, value)); }),
                    AllOf(HasSubstr(key), HasSubstr("expected")))
            << path;
    }
}

TEST(TrainSettings, AreReadAsTheDataSetsRuleAndSplit) {
    EXPECT_EQ(label_rule_of(with("label", "dispersion")), dataset::LabelRule::dispersion);
    EXPECT_EQ(label_rule_of(with("label", "fisher")), dataset::LabelRule::fisher);
    EXPECT_EQ(split_of(with("split", "paper")), dataset::Split::paper);
    EXPECT_EQ(split_of(with("split", "held_out")), dataset::Split::held_out);
}

}  // namespace
}  // namespace ddtool::train
