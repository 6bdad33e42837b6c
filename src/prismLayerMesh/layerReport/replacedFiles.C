/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "replacedFiles.H"
#include "error.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "throwingErrors.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static Foam::fileName scratchFolder(const Foam::fileName& target)
{
    return target + "~new";
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::fileName Foam::replacedFiles::old(const label i) const
{
    return scratchFolder(targets_[i])/"old";
}


bool Foam::replacedFiles::replace(const label i) const
{
    return (!exists(targets_[i], false) || mv(targets_[i], old(i)))
        && mv(written_[i], targets_[i]);
}


void Foam::replacedFiles::putBack(const label i) const
{
    if (!exists(written_[i], false))
    {
        mv(targets_[i], written_[i]);
    }

    if (exists(old(i), false))
    {
        mv(old(i), targets_[i]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::replacedFiles::scratch
(
    const fileName& target,
    const fileName& written
)
{
    const fileName folder(scratchFolder(target));
    targets_.append(target);
    written_.append(folder/written);

    // One may be left of a run that was killed
    if (isDir(folder))
    {
        rmDir(folder);
    }
    mkDir(folder);

    return folder;
}


Foam::fileName Foam::replacedFiles::written(const fileName& target) const
{
    return written_[targets_.find(target)];
}


void Foam::replacedFiles::replaceAll()
{
    forAll(targets_, i)
    {
        if (!replace(i))
        {
            for (label j = i; j >= 0; --j)
            {
                putBack(j);
            }

            FatalErrorInFunction
                << "Cannot replace " << targets_[i] << exit(FatalError);
        }
    }

    removeScratch();
}


void Foam::replacedFiles::removeScratch() const
{
    for (const fileName& target : targets_)
    {
        if (isDir(scratchFolder(target)))
        {
            rmDir(scratchFolder(target));
        }
    }
}


void Foam::replaceFiles(const std::function<void(replacedFiles&)>& write)
{
    replacedFiles files;

    // What was certified is what is written: no digit may be lost
    IOstream::defaultPrecision(17);

    try
    {
        const throwingErrors throwing(true);
        write(files);
        files.replaceAll();
    }
    catch (const Foam::error& failure)
    {
        files.removeScratch();

        FatalErrorInFunction
            << "Cannot write " << files.current() << nl
            << failure.message().c_str() << nl
            << "All files of the case are as they were" << exit(FatalError);
    }
}


void Foam::checkEnd(const fileName& file, const string& end)
{
    IFstream is(file);
    std::istream& text = is.stdStream();

    // From the start if the file is compressed, or shorter
    if (!text.seekg(-200, std::ios_base::end))
    {
        text.clear();
    }

    string last;
    for (std::string line; std::getline(text, line);)
    {
        if (line.size())
        {
            last = line;
        }
    }

    if (!last.ends_with(end))
    {
        FatalErrorInFunction
            << "The end of " << file << " is missing. Is the disk full?"
            << exit(FatalError);
    }
}


// ************************************************************************* //
