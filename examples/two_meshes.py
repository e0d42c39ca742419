import numpy as np
import tamis

floor = np.array([[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0]])
floor_faces = np.array([[0, 1, 2], [0, 2, 3]])
body = np.array([[0.3, 0.1, 1], [1, 0, 2], [0, 1, 2], [0, 0, 2]])
body_faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])

start = np.concatenate([floor, body])                             # append the vertices
end = np.concatenate([floor, body - [0, 0, 4]])
faces = np.concatenate([floor_faces, body_faces + len(floor)])    # offset the faces
detector = tamis.Detector(tamis.Mesh(faces))                      # one Detector
first = detector.earliest(start, end)
print(f"free up to {first.toi_lower:.6f} of the step")
print(f"then vertex {first.contact.vertices[0] - len(floor)} of the body meets the floor")
