/* What every call returns. */
#ifndef TAMIS_C_STATUS_H
#define TAMIS_C_STATUS_H
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define TAMIS_API __attribute__((visibility("default")))
#else
#define TAMIS_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum tamis_status {
  TAMIS_OK = 0,
  TAMIS_INVALID_ARGUMENT = 1, /**< a pointer that is NULL, a size or a place that cannot be */
  TAMIS_INVALID_MESH = 2,     /**< a topology that cannot be used */
  TAMIS_INVALID_STEP = 3,     /**< positions that do not fit the mesh, or are not finite */
  TAMIS_INVALID_OPTIONS = 4,  /**< an option outside its range, or an unknown name */
  TAMIS_CANCELLED = 5,        /**< tamis_options.is_cancelled said so; the detector may be asked again */
  TAMIS_BUSY = 6,             /**< the detector is answering another thread, or the filter's own caller */
  TAMIS_OUT_OF_MEMORY = 7,
  TAMIS_FAILED = 8,      /**< anything else */
  TAMIS_INVALID_PATH = 9 /**< a path that does not fit, or breaks its promises */
} tamis_status;

/** As the project's version, "0.1.0". Never freed, as all strings that are returned. */
TAMIS_API const char* tamis_version(void);

#ifdef __cplusplus
}
#endif
#endif
