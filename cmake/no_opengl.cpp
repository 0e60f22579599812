// OpenCV asks the X server for OpenGL's functions and for a window that is drawn in. ddtool never shows a window, so
// that the programs with OpenCV inside need no OpenGL library to ask with: there is nothing of both.
extern "C" {
void* glXGetProcAddressARB(const unsigned char* name);
void* glXGetCurrentContext();
void* glXGetCurrentDisplay();

void* glXGetProcAddressARB(const unsigned char* /*name*/) { return nullptr; }
void* glXGetCurrentContext() { return nullptr; }
void* glXGetCurrentDisplay() { return nullptr; }
}
