/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeObjects.H"
#include "objectRegistry.H"

namespace Foam
{

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool writeObjects(const objectRegistry& registry)
{
    DynamicList<const regIOobject*> objects;
    for (const word& name : registry.sortedNames())
    {
        const regIOobject* object = registry[name];
        if (object->writeOpt() != IOobject::NO_WRITE)
        {
            objects.append(object);
        }
    }

    const label n = objects.size();
    boolList written(n, false);
    List<string> failures(n);

    #pragma omp parallel for schedule(dynamic) if (!Pstream::parRun())
    for (label i = 0; i < n; ++i)
    {
        try
        {
            written[i] = objects[i]->write();
        }
        catch (const Foam::error& failure)
        {
            failures[i] = failure.message();
        }
    }

    for (const string& failure : failures)
    {
        if (failure.size())
        {
            FatalErrorInFunction << failure.c_str() << exit(FatalError);
        }
    }

    return !written.found(false);
}

} // End namespace Foam

// ************************************************************************* //
