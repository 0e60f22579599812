#pragma once

#include "ddtool/network/image_settings.hpp"
#include "system/setting_rows.hpp"

namespace ddtool {

/// The description of each image setting.
const SettingTable<ImageSettings>& image_setting_rows();

}  // namespace ddtool
