/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "throwingErrors.H"
#include "error.H"

#include <cfenv>
#include <cstdlib>
#include <new>

namespace Foam
{

namespace
{

//- As long as it lives, fatal errors and a lack of memory throw exceptions,
//  and readers print nothing
class quietReading
{
    const throwingErrors throwing_ = throwingErrors(true);
    const int level_ = messageStream::level;
    const std::new_handler newHandler_ = std::set_new_handler(nullptr);
    std::fenv_t environment_;

public:

    quietReading()
    {
        messageStream::level = 0;

        // A comparison with NaN must not end the process
        std::feholdexcept(&environment_);
    }

    ~quietReading()
    {
        std::fesetenv(&environment_);
        std::set_new_handler(newHandler_);
        messageStream::level = level_;
    }
};

} // End anonymous namespace


void failToRead(const fileName& file, const string& what)
{
    FatalErrorInFunction
        << "Cannot read the surface " << file << ": " << what.c_str()
        << exit(FatalError);

    std::abort();
}


void readGuarded(const fileName& file, const std::function<void()>& read)
{
    string what;

    try
    {
        const quietReading guard;
        read();
    }
    catch (const Foam::error& e)
    {
        what = e.message();
    }
    catch (const std::bad_alloc&)
    {
        what = "it asks for more memory than there is; is it broken?";
    }
    catch (const std::exception& e)
    {
        what = e.what();
    }

    if (what.size())
    {
        failToRead(file, what);
    }
}

} // End namespace Foam

// ************************************************************************* //
