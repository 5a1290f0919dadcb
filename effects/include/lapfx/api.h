// LAPFX_API marks what the shared library liblapfx.so exports; the private parts of what is marked are LAPFX_HIDDEN.
// A host needs neither.
#pragma once

#define LAPFX_API __attribute__((visibility("default")))
#define LAPFX_HIDDEN __attribute__((visibility("hidden")))
