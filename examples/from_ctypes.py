import ctypes as c
class Sized(c.Structure): _fields_ = [("size", c.c_size_t), ("vertex_count", c.c_int32), ("a", c.c_void_p), ("b", c.c_size_t)]
library = c.CDLL("libtamis_c.so.0.1")
faces = (c.c_int32 * 6)(0, 1, 2, 3, 4, 5)
start = (c.c_double * 18)(0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, 1, 1, 0.5, 2, 0.5, 1, 2)
end = (c.c_double * 18)(0, 0, 0, 1, 0, 0, 0, 1, 0, 0.25, 0.25, -1, 1, 0.5, 2, 0.5, 1, 2)
mesh, detector, lower, upper, count = c.c_void_p(), c.c_void_p(), c.c_double(), c.c_double(), c.c_size_t()
library.tamis_mesh_create(c.byref(Sized(32, 6, c.addressof(faces), 2)), c.byref(mesh))
library.tamis_detector_create(mesh, None, c.byref(detector))
step = Sized(32, 6, c.addressof(start), c.addressof(end))
library.tamis_detector_earliest(detector, c.byref(step), c.byref(lower), c.byref(upper), c.byref(count))
print(f"free before {lower.value:.6f}, {count.value} contact there")
