/* The status that calls return. */
#ifndef TAMIS_C_STATUS_H
#define TAMIS_C_STATUS_H
#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(tamis_c_EXPORTS) /* the library itself is being compiled */
#define TAMIS_API __declspec(dllexport)
#elif defined(_WIN32)
#define TAMIS_API __declspec(dllimport)
#elif defined(__GNUC__)
#define TAMIS_API __attribute__((visibility("default")))
#else
#define TAMIS_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What a call returns. */
typedef enum tamis_status {
  TAMIS_OK = 0,               /**< the call did what it says */
  TAMIS_INVALID_ARGUMENT = 1, /**< a pointer that is NULL, or a size or a place out of range */
  TAMIS_INVALID_MESH = 2,     /**< a topology that cannot be used */
  TAMIS_INVALID_STEP = 3,     /**< positions that do not fit the mesh, or are not finite */
  TAMIS_INVALID_OPTIONS = 4,  /**< an option outside its range, or an unknown name */
  TAMIS_CANCELLED = 5,        /**< is_cancelled ended the question; the detector may be queried again */
  TAMIS_BUSY = 6, /**< the detector or world is still answering another question: of another thread, or of the filter's
                     own caller */
  TAMIS_OUT_OF_MEMORY = 7, /**< memory is exhausted */
  TAMIS_FAILED = 8,        /**< anything else */
  TAMIS_INVALID_PATH = 9   /**< a path that does not fit the mesh, or breaks its promises */
} tamis_status;

/** Returns the version of the library, such as "0.1.0". Never free it, nor any other string that is returned. */
TAMIS_API const char* tamis_version(void);
/** Returns 1 if questions have threads of their own: oneTBB's. Returns 0 if the library was built without oneTBB. Then
 * a question without a parallel_for runs on the calling thread, whatever `threads` says. */
TAMIS_API int tamis_has_threads(void);

#ifdef __cplusplus
}
#endif
#endif
