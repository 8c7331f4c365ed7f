#!/usr/bin/python3
"""Makes the files beside it, which the tests read: volumes as other programs write them.

Usage: make_samples.py FOLDER. Needs Debian 12's python3-nibabel (5.0.0), python3-pydicom (2.3.1), python3-vtk9 (9.1.0),
teem-apps (1.12.0) and plastimatch (1.9.4, which reads and writes through ITK 5.2.1).

All hold one thing: a block of 7 x 6 x 5 voxels of a patient, of value 10, with five markers. The markers lie at known
places of the patient, in mm, x to the left, y to the back, z to the head (LPS):

    value 100  at (-10,  20,  30)   the corner that is right, front, foot, of all voxels
    value 120  at most left,        from there along x
    value 140  at most to the back, from there along y
    value 160  at most to the head, from there along z
    value 180  one voxel left, two to the back, three to the head of the corner

"upright" files have the axes of LPS; spacings are 2, 3 and 4 mm. "oblique" ones are turned by a rotation that mixes all
axes, and have their second axis flipped. The test knows the same (samples_test.cpp).
"""

import os
import pathlib
import subprocess
import sys

import nibabel
import numpy
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.uid import CTImageStorage, EnhancedCTImageStorage, ExplicitVRLittleEndian, RLELossless
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

SIZE = (7, 6, 5)
SPACING = (2.0, 3.0, 4.0)
ORIGIN = (-10.0, 20.0, 30.0)
LPS_FROM_RAS = numpy.diag([-1.0, -1.0, 1.0, 1.0])


def block(kind):
    """By [i, j, k], with i to the left, j to the back and k to the head."""
    values = numpy.full(SIZE, 10, kind)
    values[0, 0, 0] = 100
    values[-1, 0, 0] = 120
    values[0, -1, 0] = 140
    values[0, 0, -1] = 160
    values[1, 2, 3] = 180
    return values


def upright():
    """LPS from indices."""
    affine = numpy.diag([*SPACING, 1.0])
    affine[:3, 3] = ORIGIN
    return affine


def oblique():
    """LPS from indices of the block with its second axis flipped: a rotation by 25 degrees about (1, 2, 3)."""
    axis = numpy.array([1.0, 2.0, 3.0]) / numpy.sqrt(14.0)
    angle = numpy.radians(25.0)
    cross = numpy.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    turn = numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross
    affine = numpy.eye(4)
    affine[:3, :3] = turn @ numpy.diag(SPACING)
    affine[:3, 3] = ORIGIN
    flip = numpy.diag([1.0, -1.0, 1.0, 1.0])
    flip[1, 3] = SIZE[1] - 1
    return affine @ flip


def write_nifti(folder):
    kinds = {"upright": (upright(), block(numpy.int16)), "oblique": (oblique(), block(numpy.int16)[:, ::-1, :])}
    for name, (affine, values) in kinds.items():
        image = nibabel.Nifti1Image(values, LPS_FROM_RAS @ affine)
        image.header.set_xyzt_units("mm", "sec")
        nibabel.save(image, folder / f"{name}.nii")
        nibabel.save(image, folder / f"{name}.nii.gz")
    # Big-endian, with a slope, by the qform alone.
    header = nibabel.Nifti1Header(endianness=">")
    header.set_data_dtype(numpy.dtype(">i2"))
    values = block(numpy.int16)[:, ::-1, :]
    image = nibabel.Nifti1Image((values + 20) * 2, None, header)  # nibabel stores integers as they are
    image.set_qform(LPS_FROM_RAS @ oblique(), code=1)
    image.set_sform(None, code=0)
    image.header.set_xyzt_units("mm", "sec")
    image.header.set_slope_inter(0.5, -20)
    nibabel.save(image, folder / "big_endian_qform.nii")
    # Three times, 2.5 s apart: the values rise by 1.
    series = numpy.stack([block(numpy.float32) + t for t in range(3)], axis=3)
    image = nibabel.Nifti2Image(series, LPS_FROM_RAS @ upright())
    image.header.set_xyzt_units("mm", "sec")
    image.header["pixdim"][4] = 2.5
    nibabel.save(image, folder / "series_nifti2.nii.gz")


def dicom_of(name, number, instance, shape, is_signed):
    """A data set of CT, of 12 bits in 16, without its pixels and where they lie."""
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = CTImageStorage
    series = f"1.2.826.0.1.3680043.8.498.{number}"
    meta.MediaStorageSOPInstanceUID = f"{series}.{instance}"
    meta.TransferSyntaxUID = ExplicitVRLittleEndian
    data = FileDataset(None, {}, file_meta=meta, preamble=b"\0" * 128)
    data.is_little_endian = True
    data.is_implicit_VR = False
    data.SOPClassUID = CTImageStorage
    data.SOPInstanceUID = meta.MediaStorageSOPInstanceUID
    data.PatientName = "Made^Block"
    data.PatientID = "1"
    data.StudyInstanceUID = "1.2.826.0.1.3680043.8.498.1"
    data.SeriesInstanceUID = series
    data.SeriesNumber = number
    data.SeriesDescription = name
    data.Modality = "CT"
    data.InstanceNumber = instance
    data.SamplesPerPixel = 1
    data.PhotometricInterpretation = "MONOCHROME2"
    data.Columns, data.Rows = shape
    data.BitsAllocated = 16
    data.BitsStored = 12
    data.HighBit = 11
    data.PixelRepresentation = 1 if is_signed else 0
    return data


def decimals(numbers):
    return [f"{x:.9g}" for x in numbers]


def orientation(affine):
    """Rows of DICOM run along i, its columns along j."""
    return decimals((*(affine[:3, 0] / SPACING[0]), *(affine[:3, 1] / SPACING[1])))


def pixels(plane, slope, intercept):
    """Of 12 bits: nothing stands in the upper four, no sign either."""
    stored = numpy.rint((plane.T - intercept) / slope).astype(numpy.int16)
    return numpy.ascontiguousarray(stored.view(numpy.uint16) & 0xFFF).tobytes()


def write_dicom(folder, name, number, affine, values, syntax, slopes, intercept, is_signed=False,
                time=None):
    """A file for each slice [:, :, k], named against the order of their positions. `time` in ms."""
    target = folder / name
    target.mkdir(exist_ok=True)
    for k in range(values.shape[2]):
        data = dicom_of(name, number, values.shape[2] - k, values.shape[:2], is_signed)
        slope = slopes[k % len(slopes)]
        data.ImagePositionPatient = decimals(affine[:3, 3] + k * affine[:3, 2])
        data.ImageOrientationPatient = orientation(affine)
        data.PixelSpacing = decimals((SPACING[1], SPACING[0]))
        data.SliceThickness = f"{SPACING[2]:g}"
        data.RescaleSlope = f"{slope:g}"
        data.RescaleIntercept = f"{intercept:g}"
        data.PixelData = pixels(values[:, :, k], slope, intercept)
        if syntax == RLELossless:
            data.compress(RLELossless)
        if time is not None:
            data.TriggerTime = f"{time:g}"
        data.save_as(target / f"im{(k * 3) % 5}{'' if time is None else f'_{time}'}.dcm", write_like_original=False)


def write_dicom_frames(folder, name, number, affine, values):
    """One file with a frame for each slice, from the last to the first."""
    data = dicom_of(name, number, 1, values.shape[:2], False)
    data.file_meta.MediaStorageSOPClassUID = data.SOPClassUID = EnhancedCTImageStorage
    data.NumberOfFrames = values.shape[2]
    shared, measures, plane, meaning = Dataset(), Dataset(), Dataset(), Dataset()
    measures.PixelSpacing = decimals((SPACING[1], SPACING[0]))
    plane.ImageOrientationPatient = orientation(affine)
    meaning.RescaleSlope, meaning.RescaleIntercept, meaning.RescaleType = "1", "-1024", "HU"
    shared.PixelMeasuresSequence = [measures]
    shared.PlaneOrientationSequence = [plane]
    shared.PixelValueTransformationSequence = [meaning]
    data.SharedFunctionalGroupsSequence = [shared]
    frames = []
    stored = b""
    for k in reversed(range(values.shape[2])):
        frame, position = Dataset(), Dataset()
        position.ImagePositionPatient = decimals(affine[:3, 3] + k * affine[:3, 2])
        frame.PlanePositionSequence = [position]
        frames.append(frame)
        stored += pixels(values[:, :, k], 1, -1024)
    data.PerFrameFunctionalGroupsSequence = frames
    data.PixelData = stored
    data.save_as(folder / f"{name}.dcm", write_like_original=False)


def write_vti(folder):
    def image_of(values):
        image = vtkImageData()
        image.SetDimensions(*SIZE)
        image.SetSpacing(*SPACING)
        image.SetOrigin(*ORIGIN)
        array = numpy_to_vtk(numpy.asfortranarray(values).ravel(order="F"), deep=True)
        array.SetName("density")
        image.GetPointData().SetScalars(array)
        return image

    def write(name, values, mode, raw, compressed, big, wide):
        writer = vtkXMLImageDataWriter()
        writer.SetInputData(image_of(values))
        writer.SetFileName(str(folder / name))
        writer.SetDataMode(mode)
        writer.SetEncodeAppendedData(0 if raw else 1)
        writer.SetByteOrder(0 if big else 1)
        writer.SetHeaderType(64 if wide else 32)
        if not compressed:
            writer.SetCompressorTypeToNone()
        # Several blocks.
        writer.SetBlockSize(128)
        writer.Write()

    write("ascii.vti", block(numpy.float32), 0, False, False, False, False)
    write("binary.vti", block(numpy.int16), 1, False, False, False, False)
    write("binary_zlib.vti", block(numpy.int16), 1, False, True, False, True)
    write("appended_raw.vti", block(numpy.uint8), 2, True, False, False, True)
    write("appended_raw_zlib.vti", block(numpy.float64), 2, True, True, True, False)
    write("appended_base64.vti", block(numpy.int64), 2, False, False, True, True)
    write("appended_base64_zlib.vti", block(numpy.uint16), 2, False, True, False, False)
    # Of VTK, which writes no orientation into it.
    writer = vtkMetaImageWriter()
    writer.SetInputData(image_of(block(numpy.uint8)))
    writer.SetFileName(str(folder / "vtk.mha"))
    writer.SetCompression(True)
    writer.Write()


def run(*words):
    subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL)


def write_itk(folder):
    """What ITK makes of nibabel's files."""
    for name in ("upright", "oblique"):
        run("plastimatch", "convert", "--input", folder / f"{name}.nii", "--output-img", folder / f"itk_{name}.mha")
        run("plastimatch", "convert", "--input", folder / f"{name}.nii", "--output-img", folder / f"itk_{name}.mhd")
        run("plastimatch", "convert", "--input", folder / f"{name}.nii", "--output-img", folder / f"itk_{name}.nrrd")


def write_nrrd(folder):
    """Of Teem: without a space, with one, in several encodings."""
    values = block(numpy.int16)
    raw = folder / "block.raw"
    raw.write_bytes(values.tobytes(order="F"))
    make = ["teem-unu", "make", "-i", raw, "-t", "short", "-s", *SIZE, "-en", "little", "-e", "raw"]
    run(*make, "-sp", *SPACING, "-o", folder / "teem_plain.nrrd")
    flipped = block(numpy.int16)[:, ::-1, :]
    raw.write_bytes(flipped.tobytes(order="F"))
    ras = LPS_FROM_RAS @ oblique()

    def directions(affine):
        return "".join("({})".format(",".join(f"{x:.17g}" for x in affine[:3, axis])) for axis in range(3))

    origin = "({})".format(",".join(f"{x:.17g}" for x in ras[:3, 3]))
    space = ["-spc", "RAS", "-dirs", directions(ras), "-orig", origin]
    run(*make, *space, "-o", folder / "teem_ras.nrrd")
    las = numpy.diag([1.0, -1.0, 1.0, 1.0]) @ oblique()
    origin = "({})".format(",".join(f"{x:.17g}" for x in las[:3, 3]))
    run(*make, "-spc", "LAS", "-dirs", directions(las), "-orig", origin, "-o", folder / "teem_las.nrrd")
    for encoding in ("gzip", "bzip2", "ascii", "hex"):
        run("teem-unu", "save", "-f", "nrrd", "-e", encoding, "-i", folder / "teem_ras.nrrd",
            "-o", folder / f"teem_{encoding}.nrrd")
    run("teem-unu", "save", "-f", "nrrd", "-e", "raw", "-en", "big", "-i", folder / "teem_ras.nrrd",
        "-o", folder / "teem_detached.nhdr")
    raw.unlink()


def main():
    folder = pathlib.Path(sys.argv[1])
    os.environ["LC_ALL"] = "C"
    write_nifti(folder)
    flipped = block(numpy.int16)[:, ::-1, :]
    write_dicom(folder, "dicom_upright", 7, upright(), block(numpy.int16), ExplicitVRLittleEndian, (1,), -1024)
    write_dicom(folder, "dicom_oblique", 8, oblique(), flipped, RLELossless, (2,), -1000)
    write_dicom(folder, "dicom_slopes", 9, oblique(), flipped, ExplicitVRLittleEndian, (0.5, 0.25), 200, True)
    for time in (0, 400):
        write_dicom(folder, "dicom_times", 11, upright(), block(numpy.int16) + time // 400, ExplicitVRLittleEndian, (1,),
                    -1024, time=time)
    write_dicom_frames(folder, "dicom_frames", 10, oblique(), flipped)
    write_vti(folder)
    write_nrrd(folder)
    write_itk(folder)


if __name__ == "__main__":
    main()
