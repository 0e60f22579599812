#pragma once

#include "ddtool/network/image_settings.hpp"
#include "system/setting_rows.hpp"

namespace ddtool {

const SettingTable<ImageSettings>& image_setting_rows();

}  // namespace ddtool
